/// \file
/// Rows of a NumPy array file, one at a time.
#pragma once

#include "soms/io/detail/numbers/line_reader.h"
#include "soms/io/detail/numbers/npy_header.h"
#include "soms/io/rows.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// Rows of an array (N, k) of floats, where one of the headers has k columns. Where that has 12,
/// the array may also be (N, 3, 4), or (N, 4, 4) with 0, 0, 0, 1 in each last line: matrices.
class NpyRows {
 public:
  /// Reads the header. `file` stands at the beginning, and must stay.
  /// \errors ErrorKind::bad_file; those of `file`.
  NpyRows(LineReader& file, std::string_view what, std::span<const std::vector<Column>> headers);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }

  /// As `RowReader::next`; also ErrorKind::bad_file where the file ends before its last row or
  /// after it.
  [[nodiscard]] std::optional<std::span<const double>> next();

  /// As `RowReader::ready`.
  [[nodiscard]] bool ready() { return file_.has_bytes(left_ == 0 ? 1 : row_bytes()); }

  /// `fault` with the file and the row that `next` gave last in front.
  [[nodiscard]] std::string here(const std::string& fault) const;

 private:
  void read_header();
  void choose_columns(std::string_view what, std::span<const std::vector<Column>> headers);

  [[nodiscard]] std::size_t row_bytes() const { return stored_ * header_.width; }

  void read_numbers(std::string_view bytes);

  LineReader& file_;
  NpyHeader header_;
  std::vector<Column> columns_;
  std::size_t stored_ = 0;  ///< numbers of a row in the file: as many as columns, or 16
  std::uint64_t rows_ = 0;
  std::uint64_t left_ = 0;  ///< rows that are not read
  std::vector<double> numbers_;
};

}  // namespace soms::detail
