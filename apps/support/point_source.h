/// \file
/// Points of --points, row by row.
#pragma once

#include "soms/base/error.h"
#include "soms/base/vector.h"
#include "soms/io/poses.h"

#include <optional>
#include <string>

namespace soms::command {

class Console;

/// Points of a CSV file with the header x,y,z, one at a time. Rows after the first are read when
/// they are requested: the program that writes them may wait for answers.
class PointSource {
 public:
  /// `path` names a CSV file; "-" is standard input. Ctrl-C and --timeout, of `console`, end the
  /// reading of rows.
  /// \errors As `PoseReader` and `check_standard_input`; ErrorKind::bad_file for other columns;
  ///         timed_out.
  PointSource(const std::string& path, const Console& console);

  /// The next point, or nothing at the end.
  /// \errors As `PoseReader::next`; ErrorKind::bad_file for a file without rows; timed_out.
  [[nodiscard]] std::optional<Vec3> next();

  /// True if `next` will not wait.
  [[nodiscard]] bool ready() { return reader_->ready(); }

  /// Of the file, as messages name it.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[noreturn]] void fail(const Error& error) const;

  std::string name_;
  const Console& console_;
  std::optional<PoseReader> reader_;
  bool any_ = false;  ///< a point was read
};

}  // namespace soms::command
