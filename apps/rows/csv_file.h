/// \file
/// A table for spreadsheets and scripts, written line by line.
#pragma once

#include "apps/output/output.h"

#include <cstddef>
#include <string>

namespace soms::command {

class CsvFile {
 public:
  /// Opens the file. \errors ErrorKind::cannot_write.
  explicit CsvFile(const std::string& path) : file_(path) {}

  /// The line that is not ended yet.
  [[nodiscard]] std::string& line() { return text_; }

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void end_line() {
    text_ += '\n';
    if (text_.size() > kPiece) {
      write();
    }
  }

  /// Makes the file appear. \errors As `end_line`.
  void finish() {
    write();
    file_.commit();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 15;  // bytes that are written at once

  void write() {
    file_.stream() << text_;
    text_.clear();
    if (!file_.stream().good()) {
      file_.check();
    }
  }

  OutputFile file_;
  std::string text_;  ///< lines that are not written yet, and one that is not ended
};

}  // namespace soms::command
