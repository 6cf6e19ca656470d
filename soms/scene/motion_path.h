/// \file
/// A path of a body: poses one after the other, and the motion from each to the next.
///
/// \code
/// const soms::MotionPath path =
///     soms::motion_path({soms::Pose::translation(0, 0, 0), soms::Pose::translation(4, 0, 0),
///                        soms::Pose::translation(4, 3, 0)});
/// std::cout << path.segments() << " motions, " << path.chainage.back() << " long\n";
/// const soms::Pose middle = soms::pose_at(path, 1, 0.5);
/// std::cout << "the origin goes through " << middle.apply({0, 0, 0}) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 2 motions, 7 long
/// the origin goes through Vec3{4, 1.5, 0}
/// \endverbatim
#pragma once

#include "soms/base/pose.h"

#include <cstddef>
#include <vector>

namespace soms {

/// Poses that a body takes in turn. From one to the next, at parts t from 0 to 1 of the way:
///
/// - the pivot, a point of the body, moves on a straight line at constant speed;
/// - meanwhile the body turns about the pivot the shorter way, about one axis. Its rotation is that
///   of the quaternion q0 + t (q1 - q0), whose length is made 1. Here q0 and q1 are those of the
///   two poses, with signs that leave the smaller angle.
///
/// Only additions, products, quotients and square roots are needed, so poses between are the same
/// bits everywhere. Which way a half turn goes is not promised.
struct MotionPath {
  std::vector<Pose> poses = {};  ///< n, at least one
  /// n, ascending: the length of the path up to each pose. Between two that are equal, the body
  /// turns on the spot.
  std::vector<double> chainage = {};
  Vec3 pivot = {};  ///< in the coordinates of the body

  [[nodiscard]] bool operator==(const MotionPath&) const = default;

  /// Motions from one pose to the next.
  [[nodiscard]] std::size_t segments() const { return poses.empty() ? 0 : poses.size() - 1; }
};

/// A path through poses; its chainage is the length of the line of the pivot, from 0.
/// \errors As `check(MotionPath)`.
[[nodiscard]] MotionPath motion_path(std::vector<Pose> poses, const Vec3& pivot = {});

/// Throws unless there is a pose, all are rigid, and there is a chainage for each, finite and
/// ascending.
/// \errors ErrorKind::usage; as `check(Pose)`, with the index of the pose.
void check(const MotionPath& path);

/// The pose at a part `t` of the motion from pose `segment` to the next; at 0 and 1 the pose of the
/// path, bit by bit. \pre `path` passes `check`, `segment` < path.segments(), 0 <= t <= 1.
[[nodiscard]] Pose pose_at(const MotionPath& path, std::size_t segment, double t);

}  // namespace soms
