/// \file
/// A script element of a page that holds numbers as base64.
#pragma once

#include "apps/report/base64.h"

#include <ostream>
#include <string_view>

namespace soms::report {

class DataBlock {
 public:
  /// Opens the element "soms-ID".
  DataBlock(std::ostream& out, std::string_view id) : out_(out), data_(out) {
    out_ << "<script type=\"text/plain\" id=\"soms-" << id << "\">";
  }

  [[nodiscard]] Base64Writer& data() { return data_; }

  /// Closes it. Call it once, last.
  void finish() {
    data_.finish();
    out_ << "</script>\n";
  }

 private:
  std::ostream& out_;
  Base64Writer data_;
};

}  // namespace soms::report
