/// \file
/// Reading rows of numbers, one at a time.
#pragma once

#include "soms/base/error.h"
#include "soms/base/limits.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms {

/// A column of numbers.
struct Column {
  std::string_view name;         ///< must outlive the reader, as a literal does
  bool may_be_infinite = false;  ///< "inf" is a number of it

  [[nodiscard]] bool operator==(const Column&) const = default;
};

/// Rows of a CSV file whose header names its columns, or of a NumPy array file (.npy), read row by
/// row: a million rows need no more memory than one. The columns of a CSV file may stand in any
/// order, with commas or semicolons between them; decimals have a point. The first bytes of a file
/// say what it is, whatever its name.
///
/// A NumPy archive (.npz, as numpy.savez writes it) is read at once. It holds one array, or one
/// that is named as the rows are: `points`.
///
/// An array has the shape (N, k), where one of the headers has k columns, in their order; where
/// that has 12, (N, 3, 4) and (N, 4, 4) too: matrices by lines, of which a fourth line must be 0,
/// 0, 0, 1. Its numbers are little-endian floats of 4 or 8 bytes, in C order.
class RowReader {
 public:
  /// `what` is what the rows are, in messages: "poses". The header of a CSV file must name each
  /// column of one of `headers` once, and no other. A stop of `limits` ends this and `next`, also
  /// while they wait for a pipe.
  /// \errors  ErrorKind::cannot_open, bad_file, cancelled.
  RowReader(const std::filesystem::path& path, std::string_view what,
            std::vector<std::vector<Column>> headers, const Limits& limits = {});
  ~RowReader();
  RowReader(RowReader&&) noexcept;
  RowReader& operator=(RowReader&&) noexcept;

  /// That one of `headers` which the file has.
  [[nodiscard]] const std::vector<Column>& columns() const;

  /// The numbers of the next row, in the order of `columns`, valid until the next call; nothing
  /// at the end. Blank lines and lines that start with # are skipped.
  /// \errors  ErrorKind::bad_file, not_finite; the message names file and line, or row. cannot_open
  ///          (reading failed), cancelled.
  [[nodiscard]] std::optional<std::span<const double>> next();

  /// True if `next` will not wait: a row or the end is at hand. Always, but where a pipe or a
  /// terminal has given no whole row yet: a program that gives a row and waits for what comes of it
  /// has to be answered before the next row is requested. What is wrong with a row, `next` tells.
  [[nodiscard]] bool ready();

  /// What is wrong with the numbers of the row that `next` gave last, with file and line in front.
  [[nodiscard]] Error fault(const Error& error) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms
