/// \file
/// Answers as a table for spreadsheets and scripts.
#pragma once

#include "apps/output/output.h"

#include <optional>
#include <string>
#include <string_view>

namespace soms::command {

/// A file of rows, if one is wanted.
class AnswerCsv {
 public:
  /// Opens the file and writes the names of the columns, unless `path` is empty.
  /// \errors ErrorKind::cannot_write.
  AnswerCsv(const std::string& path, std::string_view columns);

  /// Makes the file appear. \errors As `put`.
  void finish();

 protected:
  [[nodiscard]] bool is_wanted() const { return file_.has_value(); }

  /// Adds whole rows. \errors ErrorKind::cannot_write; ClosedPipe.
  void put(std::string_view rows);

 private:
  std::optional<OutputFile> file_;
};

}  // namespace soms::command
