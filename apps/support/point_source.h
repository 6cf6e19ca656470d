/// \file
/// Points of a CSV file, row by row.
#pragma once

#include "soms/base/error.h"
#include "soms/base/vector.h"
#include "soms/io/poses.h"

#include <cstdint>
#include <deque>
#include <exception>
#include <optional>
#include <string>

namespace soms::command {

class Console;

/// Points of a file whose header is x, y and z, in any order. Rows are read when they are
/// requested: the program that writes them may wait for answers.
class PointSource {
 public:
  /// Opens a file; "-" is standard input. Ctrl-C and --timeout, of `console`, end the reading.
  /// \errors As `PoseReader` and `check_standard_input`; ErrorKind::bad_file for another header;
  ///         timed_out.
  PointSource(const std::string& path, const Console& console);

  /// The next point, or nothing at the end.
  /// \errors As `PoseReader::next`; ErrorKind::bad_file for a file without rows; out_of_range
  ///         beyond 2^300; timed_out.
  [[nodiscard]] std::optional<Vec3> next();

  /// True if `next` will not wait.
  [[nodiscard]] bool ready();

  /// True if the file has one row. Reads the second one, and waits for it.
  /// \errors ErrorKind::cancelled; others wait until the row is requested.
  [[nodiscard]] bool is_single();

  /// Of the file, as messages call it.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::optional<Vec3> read();
  [[noreturn]] void fail(const Error& error) const;

  std::string name_;
  const Console* console_;
  std::optional<PoseReader> reader_;
  std::uint64_t rows_ = 0;
  std::deque<Vec3> ahead_;    ///< rows that `is_single` read
  std::exception_ptr error_;  ///< of a row that it read, thrown when that is requested
  std::optional<bool> single_;
};

}  // namespace soms::command
