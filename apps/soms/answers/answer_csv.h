/// \file
/// Answers as a table for spreadsheets and scripts.
#pragma once

#include "apps/output/output.h"
#include "apps/soms/answers/answer_fields.h"

#include <cstdint>
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

/// A row for each answer, of answers that name no triangle.
class FieldCsv : public AnswerCsv {
 public:
  /// For answers T; the first column is the number of the row, called `key`.
  template <Described T>
  [[nodiscard]] static FieldCsv of(const std::string& path, const std::string& key) {
    return FieldCsv(path, key + "," + field_head<T>() + "\n");
  }

  /// \errors ErrorKind::cannot_write; ClosedPipe.
  template <Described T>
  void add(std::uint64_t row, const T& answer) {
    if (is_wanted()) {
      put(std::to_string(row) + "," +
          field_cells(answer, [](int, const auto&) { return std::string(); }) + "\n");
    }
  }

 private:
  using AnswerCsv::AnswerCsv;
};

}  // namespace soms::command
