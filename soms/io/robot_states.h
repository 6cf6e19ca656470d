/// \file
/// Reading states of a robot, one at a time.
#pragma once

#include "soms/base/error.h"
#include "soms/base/limits.h"
#include "soms/kinematics/kinematics.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace soms {

/// States of a CSV file, row by row: a million need no more memory than one. If the first row has a
/// word that is no number, it is a header: names of joints, in any order. Without a header, and in
/// a NumPy array file (.npy, of the shape (N, k)), each row has one number for each movable joint,
/// in the order of `Kinematics::movable`.
class RobotStateReader {
 public:
  /// `home`: values of movable joints that a header does not name, one for each of `movable`;
  /// unset: it must name all. A stop of `limits` ends this and `next`, also while they wait for a
  /// pipe. \pre    `kinematics` stays. \errors ErrorKind::cannot_open; bad_file (no rows, a column
  /// of no movable joint or twice, a
  ///         joint without a column, another number of columns); cancelled.
  RobotStateReader(const std::filesystem::path& path, const Kinematics& kinematics,
                   std::optional<std::vector<double>> home = std::nullopt,
                   const Limits& limits = {});
  ~RobotStateReader();
  RobotStateReader(RobotStateReader&&) noexcept;
  RobotStateReader& operator=(RobotStateReader&&) noexcept;

  /// The values of the next state, valid until the next call; nothing at the end. Blank lines and
  /// lines that start with # are skipped.
  /// \errors ErrorKind::bad_file, not_finite; the message names file and line, or row. cannot_open
  ///         (reading failed), cancelled.
  [[nodiscard]] std::optional<std::span<const double>> next();

  /// True if `next` will not wait: as `RowReader::ready`.
  [[nodiscard]] bool ready();

  /// Joints whose values are those of `home`.
  [[nodiscard]] const std::vector<std::uint32_t>& missing() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace soms
