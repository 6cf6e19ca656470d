/// \file
/// The motion from one pose of a path to the next, and how far it moves any point of a body.
#pragma once

#include "soms/base/box.h"
#include "soms/motion/detail/quaternion.h"
#include "soms/motion/rigid_motion.h"
#include "soms/scene/motion_path.h"

namespace soms::detail {

/// A place on a segment.
struct MotionPlace {
  double t = 0;
  Pose pose;
  Quaternion turn{1, 0, 0, 0};
  /// How far `pose`, as rounded, may put a point of the body from where the motion puts it.
  double slack = 0;
};

/// A segment of a path, for a body with these bounds.
class MotionSegment {
 public:
  /// \pre As `pose_at`; `bounds` is not empty.
  MotionSegment(const MotionPath& path, std::size_t segment, const Box& bounds);

  [[nodiscard]] MotionPlace at(double t) const;

  /// At least the distance of any point of the body from its place at `a`, and from there to its
  /// place at `b`, at any time between; so no pair of triangles nears or parts by more than that,
  /// on the way there and on, together.
  [[nodiscard]] double most_motion(const MotionPlace& a, const MotionPlace& b) const;

  /// Slack of a place that is none of the two ends.
  [[nodiscard]] double slack() const { return slack_; }

 private:
  [[nodiscard]] double slack_of_end(const Pose& pose, const Quaternion& turn) const;

  RigidMotion motion_;
  double radius_ = 0;  ///< no point of the body is farther from the pivot
  double lever_ = 0;   ///< nor from the axis of the turn
  double slack_ = 0;
  double first_slack_ = 0;
  double last_slack_ = 0;
  double length_ = 0;  ///< at least the length of the pivot's line
};

}  // namespace soms::detail
