/// \file
/// Where the answers of a question go: standard output, and the files of -o.
#pragma once

#include "apps/output/npz_file.h"
#include "apps/output/output.h"
#include "apps/rows/answer_outputs.h"
#include "apps/rows/csv_file.h"
#include "apps/rows/json_rows.h"
#include "apps/rows/question.h"

#include <cstdint>
#include <optional>
#include <string>

namespace soms::command {

class Sinks {
 public:
  /// Opens the files: one that cannot be written is an error before the work, not after it.
  /// \errors ErrorKind::cannot_write.
  Sinks(const AnswerOutputs& outputs, Console& console);

  [[nodiscard]] bool has_files() const { return has_files_; }

  /// Before the first row.
  void begin(Question& question);

  /// Adds a row to all but arrays. `single`: it is the only one; `listed`: it is printed as text.
  /// \errors ErrorKind::cannot_write; ClosedPipe.
  void add(Question& question, const AnsweredRow& row, bool single, bool listed);

  /// Adds the first rows of the block to arrays. \errors As `add`.
  void add_columns(Question& question, std::size_t rows);

  /// Prints what follows the rows of a table.
  void print_totals(const Question& question, const RowTotals& totals, const std::string& noun);

  /// Makes the files appear. \errors As `add`.
  void finish(const Question& question, const RowTotals& totals);

 private:
  Console& console_;
  bool has_files_;
  JsonRows json_;
  std::optional<CsvFile> csv_;
  std::optional<NpzFile> arrays_;
  std::optional<OutputFile> page_;
  std::uint64_t printed_ = 0;  ///< rows of the table
};

}  // namespace soms::command
