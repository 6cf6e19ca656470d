/// \file
/// Poses of --pose and --pose-b, row by row.
#pragma once

#include "soms/base/pose.h"
#include "soms/io/poses.h"

#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace soms::command {

class Console;

/// Poses of one option: a single one that serves all rows, or those of a file, one at a time.
class PoseSource {
 public:
  /// The identity, for an option that is not given.
  PoseSource() : constant_(Pose::identity()) {}

  /// `text` is "x y z [qw qx qy qz]" or the path of a CSV file; "-" is standard input. A file of
  /// one row counts as a single pose.
  /// Ctrl-C and --timeout, of `console`, end the reading of rows.
  /// \errors As `parse_pose` (the message names `option`), `PoseReader` and `check_standard_input`;
  ///         ErrorKind::bad_file for a file without rows; timed_out.
  PoseSource(const std::string& option, const std::string& text, const Console& console);

  /// True if one pose serves all rows.
  [[nodiscard]] bool is_constant() const { return constant_.has_value(); }

  /// The next pose, or nothing at the end. A single pose never ends.
  /// \errors As `PoseReader::next`; ErrorKind::timed_out.
  [[nodiscard]] std::optional<Pose> next();

  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::optional<Pose> read(std::string_view path = {});

  std::string name_;
  const Console* console_ = nullptr;  ///< none where nothing is read
  std::optional<Pose> constant_;
  std::optional<PoseReader> reader_;
  std::optional<Pose> first_;
  std::optional<Pose> second_;
  std::exception_ptr error_;  ///< of the second row, thrown when it is asked for
};

/// Poses of both bodies, row by row: two files of equal length, or one file and a single pose; two
/// single poses are one row.
class PosePairs {
 public:
  PosePairs(PoseSource a, PoseSource b) : a_(std::move(a)), b_(std::move(b)) {}

  /// True if there is one row, known without reading on.
  [[nodiscard]] bool is_single() const { return a_.is_constant() && b_.is_constant(); }

  /// Name of the file that has the rows.
  [[nodiscard]] const std::string& name() const { return a_.is_constant() ? b_.name() : a_.name(); }

  /// The next row, or nothing at the end.
  /// \errors As `PoseSource::next`; ErrorKind::bad_file when one file ends before the other.
  [[nodiscard]] std::optional<std::pair<Pose, Pose>> next();

 private:
  PoseSource a_;
  PoseSource b_;
  std::uint64_t rows_ = 0;
};

}  // namespace soms::command
