/// \file
/// Elements of a COLLADA document that are left out.
#pragma once

#include "soms/io/detail/collada/collada_document.h"
#include "soms/io/detail/left_out.h"

#include <cstdint>

namespace soms::detail {

/// Elements of one kind that are not in the mesh. A scene comes to elements in an order of its own:
/// the first is the first in the file.
class ColladaLeftOut {
 public:
  /// `count` more, in this element.
  void add(pugi::xml_node element, std::uint64_t count = 1) {
    if (count > 0 && (count_ == 0 || element.offset_debug() < first_.offset_debug())) {
      first_ = element;
    }
    count_ += count;
  }

  void add(const ColladaLeftOut& more) { add(more.first_, more.count_); }

  /// For the note: the first one's line.
  [[nodiscard]] LeftOut in_line(const ColladaDocument& document) const {
    LeftOut left_out;
    left_out.add([&] { return document.place_of(first_); }, count_);
    return left_out;
  }

  /// For the note: the first one's line, and the element.
  [[nodiscard]] LeftOut by_name(const ColladaDocument& document) const {
    LeftOut left_out;
    left_out.add([&] { return document.place_of(first_) + ": " + describe(first_); }, count_);
    return left_out;
  }

 private:
  std::uint64_t count_ = 0;
  pugi::xml_node first_;
};

}  // namespace soms::detail
