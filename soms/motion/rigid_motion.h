/// \file
/// A motion of a body from one pose to another: where it is at each part of the way.
///
/// \code
/// const soms::RigidMotion motion = soms::RigidMotion::between(
///     soms::Pose::identity(), soms::Pose::from_quaternion(0, 0, 0, 1, {4, 0, 0}));
/// const soms::Pose middle = motion.pose_at(0.5);
/// std::cout << "the origin goes through " << middle.apply({0, 0, 0}) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// the origin goes through Vec3{2, 0, 0}
/// \endverbatim
#pragma once

#include "soms/base/pose.h"

#include <array>

namespace soms {

/// A rigid motion, at parts t from 0 to 1 of the way.
///
/// `between` and `turn` follow the law of MotionPath. The pivot, a point of the body, moves on a
/// straight line at constant speed. Meanwhile the body turns about it the shorter way, about one
/// axis: its rotation is that of the quaternion q0 + t (q1 - q0), whose length is made 1. `along`
/// turns nothing: the rotation is that of the pose, bit by bit.
///
/// Only additions, products, quotients and square roots are needed, so poses between are the same
/// bits everywhere.
class RigidMotion {
 public:
  /// (w, x, y, z).
  using Quaternion = std::array<double, 4>;

  /// Rests at the identity.
  RigidMotion() = default;

  /// A straight shift of the body at `start` by `by`, in world.
  /// \errors As `check(Pose)` for the start and the end; ErrorKind::not_finite for the vector.
  [[nodiscard]] static RigidMotion along(const Pose& start, const Vec3& by);

  /// From `start` to `end`; `pivot` is in the coordinates of the body. Which way a half turn goes
  /// is not promised.
  /// \errors As `check(Pose)`; ErrorKind::not_finite for the pivot.
  [[nodiscard]] static RigidMotion between(const Pose& start, const Pose& end,
                                           const Vec3& pivot = {});

  /// A turn of the body at `start` about an axis through `center`, both in world, by `angle`
  /// radians: counter-clockwise where the axis points at the viewer. The axis may have any length
  /// but 0, the angle is below a half turn either way. By the law above the body turns a little
  /// slower at both ends than in the middle. Longer turns are several motions.
  /// \errors ErrorKind::usage for an axis of length 0 and for a half turn or more; as `between`.
  [[nodiscard]] static RigidMotion turn(const Pose& start, const Vec3& center, const Vec3& axis,
                                        double angle);

  /// The pose at a part `t` of the way; at 0 and 1 the two poses, bit by bit.
  /// \pre 0 <= t <= 1
  [[nodiscard]] Pose pose_at(double t) const;

  /// As `pose_at`, but at 0 and 1, too, what the law says. A pose that is not a rotation to the
  /// last bit is none that a quaternion has.
  [[nodiscard]] Pose law_at(double t) const;

  [[nodiscard]] const Pose& start() const { return first_; }

  [[nodiscard]] const Pose& end() const { return last_; }

  /// In the coordinates of the body.
  [[nodiscard]] const Vec3& pivot() const { return pivot_; }

  /// It is made by `along`.
  [[nodiscard]] bool straight() const { return straight_; }

  /// How far `along` shifts; zero for others.
  [[nodiscard]] const Vec3& by() const { return by_; }

  /// q0 and q1: of length 1 but for rounding, with signs that leave the smaller angle.
  [[nodiscard]] const Quaternion& from() const { return from_; }

  [[nodiscard]] const Quaternion& to() const { return to_; }

  /// The places of the pivot in world, at 0 and 1.
  [[nodiscard]] const Vec3& pivot_from() const { return pivot_from_; }

  [[nodiscard]] const Vec3& pivot_to() const { return pivot_to_; }

  /// q0 + t (q1 - q0), made of length 1.
  [[nodiscard]] Quaternion quaternion_at(double t) const;

  [[nodiscard]] bool operator==(const RigidMotion&) const = default;

 private:
  Pose first_;
  Pose last_;
  Vec3 pivot_;
  Vec3 by_;
  Quaternion from_{1, 0, 0, 0};
  Quaternion to_{1, 0, 0, 0};
  Vec3 pivot_from_;
  Vec3 pivot_to_;
  bool straight_ = false;
};

}  // namespace soms
