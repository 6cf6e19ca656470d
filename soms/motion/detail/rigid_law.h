/// \file
/// The law of a RigidMotion, seen from a body that rests.
///
/// The law. In real numbers, a point a of the body is at
///   x(t) = w(t) + R(t) (a - c),
/// where w(t) runs from w0 to w1 at constant speed and R(t) is the rotation of q(t) = q0 + t d with
/// d = q1 - q0. The doubles q0, q1, w0, w1, c are those that RigidMotion holds. A straight motion
/// has x(t) = start.apply(a) + t by. Write u = 2^-53, B for the sum of the greatest |x|, |y|, |z|
/// of the body, C for that of the pivot, W for the greatest coordinate of w0 and w1. No coordinate
/// of x(t) exceeds B + C + W, as |a - c| is at most B + C; for a straight motion, the extent of the
/// start and of `by` together. Either is `reach`.
///
/// Rounding of a pose. What `law_at(t)` does to a, as a real map and by `Pose::apply`, is off x(t)
/// by at most `slack` = 2^-45 reach + 2^-1060. For a turn that is the proof of motion_segment.cpp:
/// 48 u (B + C) + 12 u W for a coordinate, less than twice that for a point, 2^-45 = 256 u. For a
/// straight motion: by is multiplied and added with 2 u |by| + u |start|, and applied with 4 u of
/// the extent: 8 u reach for a coordinate. So `pose_at(t)` puts no point farther than `slack` from
/// x(t), at 0 < t < 1. At 0 and 1 it is the caller's pose, which may be stretched by 1e-6. There
/// the traversal proves nothing: the two poses are decided as they are, by `within`.
///
/// Acceleration. x'' has no part of w. The body turns about one axis, at the distance r of a from
/// it, by the angle A(t), so |x''| <= r (A'^2 + |A''|).
///
/// Curvature. With N = |q|^2 and s = |q0| |q1| sin of the angle between q0 and q1, in four
/// dimensions, half the angle has the derivative s / N. So A' = 2 s / N, A'' = -2 s N' / N^2, where
/// N is a parabola with its least value at -q0.d / |d|^2 and N' is linear. N is at least 1/2 - 6 u,
/// as q0.q1 >= 0. Errors: s is the length of a product of quaternions, off by 16 u; N by 8 u; N' by
/// 12 u; `curvature` adds 2^-46 = 128 u to s and N', and takes N smaller by a factor 1 - 2^-46.
///
/// Distance from the axis. Through c runs the axis k = (q0 q1's vector part) / s. r is at most
/// |a - c| and at most |k x (a - c)|, but for 16 u / s of |a - c| (as in motion_segment.cpp).
///
/// Across the axis. In world the body turns about K = R(t) k, which is the same at all times. So a
/// point keeps its product with K but for w, x'' is at right angles to K, and along a direction n
/// of length 1 the bend of (1) counts by the part of n that is at right angles to K alone. That is
/// |n x K|. K is off by 120 u for the rotation of q0 and by 16 u / s for k; `across` adds 2^-44 and
/// 2^-46 / s. A body that turns over a floor does not near it.
///
/// A difference of two maps is off that of two rotations by 120 u in its norm, as each of 9 entries
/// is a handful of operations on numbers up to 1; `kTurnMargin` is 2^-44 = 512 u.
///
/// Underflow. The slack ends in 2^-1060. A curvature below 2^-200 is 0 in effect: times 2^301 it is
/// less than what 2^-46 stands for. Where q0 is q1 the curvature is 0.
#pragma once

#include "soms/motion/detail/motion_law.h"
#include "soms/motion/detail/quaternion.h"
#include "soms/query/body.h"
#include "soms/tree/shape.h"

namespace soms::detail {

inline constexpr double kMotionUnit = 0x1p-53;

inline constexpr double kSlackShare = 0x1p-45;
inline constexpr double kTurnMargin = 0x1p-44;
inline constexpr double kSineMargin = 0x1p-46;
inline constexpr double kTinySlack = 0x1p-1060;

static_assert(kSlackShare >= 2 * 2 * 48 * kMotionUnit, "rounding of a pose, twice");
static_assert(kTurnMargin >= 4 * 120 * kMotionUnit, "rounding of a difference of rotations");
static_assert(kSineMargin >= 4 * 16 * kMotionUnit, "rounding of a sine, four times");

/// How fast a body turns, at most.
struct TurnRate {
  double speed = 0;   ///< A'
  double growth = 0;  ///< |A''|
};

/// Bounds of a RigidMotion of a body, in world.
class TurnBounds {
 public:
  /// Refers to the motion.
  TurnBounds(const Shape& body, const RigidMotion& motion);

  [[nodiscard]] const RigidMotion& motion() const { return *motion_; }

  /// Its rotation changes: q0 is not q1.
  [[nodiscard]] bool turns() const { return motion_->from() != motion_->to(); }

  /// Over [ta, tb].
  [[nodiscard]] TurnRate rate(double ta, double tb) const;

  /// At least the distance of a point of the body from the axis, and from the pivot; 0 where
  /// nothing turns.
  [[nodiscard]] double arm(const Vec3& point) const;
  [[nodiscard]] double arm_of_pivot(const Vec3& point) const;

  /// At least the part of a direction of length 1 that is at right angles to the axis.
  [[nodiscard]] double across(const Vec3& n) const;

  [[nodiscard]] Twist twist_at(double t) const;

  [[nodiscard]] double reach() const { return reach_; }

  /// No pose of `law_at` puts a point of the body farther from x(t).
  [[nodiscard]] double slack() const { return kSlackShare * reach_ + kTinySlack; }

 private:
  const RigidMotion* motion_;
  Vec3 axis_;            ///< of length 1, in the body
  Vec3 axis_in_world_;   ///< likewise
  double sine_ = 0;      ///< rounded up
  double off_axis_ = 1;  ///< at least the rounding of the axis; 1 where none is known
  Quaternion step_ = {};
  double reach_ = 0;
};

/// `motion` of the mover while the other body rests.
class RigidLaw final : public MotionLaw {
 public:
  /// Refers to both.
  RigidLaw(const Shape& mover, const RigidMotion& motion, const Body& fixed);

  [[nodiscard]] Pose at(double t) const override { return bounds_.motion().law_at(t); }

  [[nodiscard]] Curvature curvature(double ta, double tb) const override;

  [[nodiscard]] double arm(const Vec3& point) const override { return bounds_.arm(point); }

  [[nodiscard]] double across(const Vec3& n) const override { return bounds_.across(n); }

  [[nodiscard]] Twist twist_at(double t) const override { return bounds_.twist_at(t); }

  [[nodiscard]] Pose mover_at(double t) const override { return bounds_.motion().pose_at(t); }

  [[nodiscard]] Pose other_at(double /*t*/) const override { return fixed_.pose; }

  [[nodiscard]] Pose resting_pose() const override { return fixed_.pose; }

  [[nodiscard]] Pose frame_at(double /*t*/) const override { return {}; }

  [[nodiscard]] const RigidMotion* alone() const override { return &bounds_.motion(); }

 private:
  TurnBounds bounds_;
  const Body& fixed_;
};

}  // namespace soms::detail
