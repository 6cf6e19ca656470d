/// \file
/// Two bodies that move, one seen from the other.
///
/// With x_A, x_B the curves of rigid_law.h, w the places of pivots, R rotations and c pivots, the
/// frame depends on whether the other body, B, turns. E is the sum of both reaches, u = 2^-53.
///
/// Where B does not turn, the frame shifts with it: y = x_A - f, f(t) the way of B since 0. Only A
/// turns, so all bounds of rigid_law.h hold as they are. The map is `law_at` of A less f, where f
/// is a difference of two shifts that `law_at` of B gives. The rotation in them is the same bits,
/// so B rests at its first one but for both slacks, 256 u E, and 4 u E. `slack` is 2^-44 E = 512 u
/// E. Poses that are decided are off by both slacks.
///
/// Where B turns, the frame is its own: y = c_B + R_B^T (R_A (a - c_A) + v), v = w_A - w_B, which
/// is straight. Where a body turns by the speed p and its growth q, |R' z| <= p |z| and
/// |R'' z| <= (p^2 + q) |z|. With r = |a - c_A|,
///   |y''| <= ((p_A + p_B)^2 + q_A + q_B) r + (p_B^2 + q_B) |v| + 2 p_B |v'|.
/// |v| is greatest at an end of a stretch.
///
/// Rounding then. Coordinates in world are at most E. |a|_1 is at most 5.2 of A's reach. The origin
/// of B is at most the reach of B from that of world along each axis, so |y|_1 <= 3 E. With those
/// of a pose on a, no partial sum exceeds 8 E, which is `reach`. The map is L = inverse(P_B) P_A,
/// of poses of `law_at`. An inverse and its pose are off the identity by 36 u in an entry and by 90
/// u of the shift's sum: P_B puts L a beside P_A a by 36 * 3 u E or 90 * 3 u E along an axis, 468 u
/// E in length. The product adds 23 u E and `apply` 32 u E along an axis, 96 u E in length. P_A a
/// is off x_A by 256 u of A's reach, P_B y off x_B by 256 u (3 E + B's reach). Together below 1600
/// u E; poses that are decided are off by 256 u E. `slack` is 2^-41 E = 4096 u E. A map is off a
/// rotation by 240 u for its factors and 36 u + 16 u for their product; the margin of a difference
/// is 2^-42 = 2048 u.
///
/// Underflow. Some 2^6 products of an entry and a length more than in one pose: 2^-1060 again.
#pragma once

#include "soms/motion/detail/motion_law.h"
#include "soms/motion/detail/rigid_law.h"

namespace soms::detail {

/// `motion` of the mover, seen from another body that moves too.
class RelativeLaw final : public MotionLaw {
 public:
  /// Refers to both motions.
  RelativeLaw(const Shape& mover, const RigidMotion& motion, const Shape& other,
              const RigidMotion& motion_of_other);

  [[nodiscard]] Pose at(double t) const override;

  [[nodiscard]] Curvature curvature(double ta, double tb) const override;

  [[nodiscard]] double arm(const Vec3& point) const override;

  [[nodiscard]] double across(const Vec3& n) const override;

  [[nodiscard]] Twist twist_at(double t) const override;

  [[nodiscard]] Pose mover_at(double t) const override { return a_.motion().pose_at(t); }

  [[nodiscard]] Pose other_at(double t) const override { return b_.motion().pose_at(t); }

  [[nodiscard]] Pose resting_pose() const override;

  [[nodiscard]] Pose frame_at(double t) const override;

 private:
  /// Of the other body, since 0.
  [[nodiscard]] Vec3 shift_at(double t) const;

  TurnBounds a_;
  TurnBounds b_;
};

}  // namespace soms::detail
