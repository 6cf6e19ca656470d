/// \file
/// Reading poses, one at a time or all.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/io/rows.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace soms {

/// Pose from a command line: `x y z` or `x y z qw qx qy qz`, separated by blanks or commas.
/// \errors  ErrorKind::usage, not_finite, not_rigid.
[[nodiscard]] Pose parse_pose(std::string_view text);

/// Poses of a CSV file with a header, `x,y,z,qw,qx,qy,qz` (the last four optional together) or
/// `r00,r01,r02,tx,r10,r11,r12,ty,r20,r21,r22,tz`, read row by row: a million rows need no more
/// memory than one. The columns may stand in any order. Or a NumPy array file of the shape (N, 3),
/// (N, 7), (N, 12), (N, 3, 4) or (N, 4, 4), as `RowReader` has it.
class PoseReader {
 public:
  /// A stop of `limits` ends this and `next`, also while they wait for a pipe.
  /// \errors  ErrorKind::cannot_open, bad_file, cancelled.
  explicit PoseReader(const std::filesystem::path& path, const Limits& limits = {});

  /// The next pose, checked, or nothing at the end. Blank lines and lines that start with # are
  /// skipped.
  /// \errors  ErrorKind::bad_file, not_finite, not_rigid; the message names file and line, or row.
  ///          cannot_open (reading failed), cancelled.
  [[nodiscard]] std::optional<Pose> next();

  /// As `RowReader::ready`.
  [[nodiscard]] bool ready() { return rows_.ready(); }

  /// As `RowReader::fault`, of the pose that `next` gave last.
  [[nodiscard]] Error fault(const Error& error) const { return rows_.fault(error); }

  /// True if the header is x, y and z alone: rows are shifts without rotations.
  [[nodiscard]] bool shifts_only() const { return rows_.columns().size() == 3; }

 private:
  RowReader rows_;
};

/// All poses of a file. \errors As `PoseReader`.
[[nodiscard]] std::vector<Pose> read_poses(const std::filesystem::path& path,
                                           const Limits& limits = {});

}  // namespace soms
