/// \file
/// Answers as rows of JSON, wherever they are wanted.
#pragma once

#include "apps/output/output.h"
#include "apps/rows/answer_outputs.h"
#include "apps/rows/json_list.h"

#include <memory>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;

/// Standard output with --json, and the files that -o names.
class JsonRows {
 public:
  /// Opens the files. \errors ErrorKind::cannot_write.
  JsonRows(const AnswerOutputs& outputs, Console& console);

  [[nodiscard]] bool is_wanted() const;

  /// Adds a piece of a row. \pre `is_wanted`. \errors ErrorKind::cannot_write; ClosedPipe.
  void put(std::string_view piece);

  /// Ends the row. \errors As `put`.
  void end_row();

  /// Ends the list, with a last object unless that is null, and makes the files appear.
  /// \errors As `put`.
  void finish(const Json& totals);

 private:
  struct File {
    std::unique_ptr<OutputFile> file;
    JsonListWriter list;
  };

  Console& console_;
  std::vector<File> files_;
};

}  // namespace soms::command
