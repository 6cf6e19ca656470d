/// \file
/// Rows of numbers of a CSV file, a NumPy array or standard input, as they come.
#pragma once

#include "soms/base/error.h"
#include "soms/base/vector.h"
#include "soms/io/rows.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms::command {

class Console;

/// What the rows of a file are.
struct RowKind {
  std::string noun;                          ///< "point"
  std::vector<std::vector<Column>> headers;  ///< those that the file may have
};

/// Rows of one file. They are read when they are requested: the program that writes them may wait
/// for answers.
class RowSource {
 public:
  /// Opens a file; "-" is standard input. Ctrl-C and --timeout, of `console`, end the reading.
  /// \errors As `RowReader` and `check_standard_input`; ErrorKind::timed_out.
  RowSource(const std::string& path, RowKind kind, const Console& console);

  /// True if `next` will not wait.
  [[nodiscard]] bool ready();

  /// True if the file has one row. Reads the second one, and waits for it.
  /// \errors ErrorKind::cancelled; others wait until the row is requested.
  [[nodiscard]] bool is_single();

  /// Of the file, as messages call it.
  [[nodiscard]] const std::string& name() const { return name_; }

 protected:
  /// The numbers of the next row, in the order of its header, valid until the next call; nothing at
  /// the end. A note says where there is none at all.
  /// \errors As `RowReader::next`; ErrorKind::timed_out.
  [[nodiscard]] std::optional<std::span<const double>> next_row();

  /// Throws what is wrong with the row that `next_row` gave last.
  [[noreturn]] void refuse(ErrorKind kind, const std::string& what,
                           const std::string& remedy) const;

  /// The point whose coordinates that row has from column `first` on.
  /// \errors ErrorKind::out_of_range for one beyond 2^300.
  [[nodiscard]] Vec3 point_of(std::span<const double> row, std::size_t first) const;

 private:
  std::optional<std::span<const double>> read();
  [[noreturn]] void fail(const Error& error) const;

  std::string name_;
  std::string noun_;
  const Console* console_;
  std::optional<RowReader> reader_;
  std::uint64_t read_ = 0;                 ///< rows
  bool reported_ = false;                  ///< that there are no rows
  std::uint64_t given_ = 0;                ///< rows, by `next_row`
  std::vector<double> row_;                ///< the last one that was read ahead and given
  std::deque<std::vector<double>> ahead_;  ///< rows that `is_single` read
  std::exception_ptr error_;               ///< of a row that it read, thrown when that is requested
  std::optional<bool> single_;
};

}  // namespace soms::command
