/// \file
/// A link of a robot between two states, seen from the cell or from another link.
///
/// With the law and the names of state_motion.h, links A and B are at X_A and X_B. From the cell, a
/// point a of A follows x = X_A a. From B it follows y = X_B^-1 X_A a: joints and base above the
/// nearest link that both hang from cancel. Either is a product of fixed poses and of motions of
/// joints, T_1 T_2 ... T_m a, where T_1 is next to the frame. On the way up from B, poses and
/// motions are inverse.
///
/// Curvature. All values are linear in t, with the rates v_j, so x'' = sum of v_i v_j d2x/dq_i dq_j
/// over all pairs of joints. Let q_j be the point that the motion of j is applied to, and rho_j its
/// distance from the axis of j where j turns, or 1 where it shifts. |dx/dq_j| = rho_j. For i before
/// j, d2x/dq_i dq_j is that vector under the derivative of the motion of i: a turn makes a vector
/// of no greater length of it, a shift 0. For i = j a turn gives rho_j, a shift 0. So
///   |x''| <= sum over j of |v_j| rho_j (|v_j| [j turns] + 2 sum of |v_i|, i before j, i turns).
/// For a point a at the distance |a| from the origin o of its link, rho_j is at most |a| more than
/// that of o. That one is at most the sum of the lengths of shifts between j and A, with the
/// greatest prismatic values. It is also at most the distance at 1/2 and half of how far o goes,
/// seen from j, in the time 1: at most the sum of |v_k| rho_k over the joints k between j and A.
/// The distance at 1/2 is measured at decided poses in world, which stretch it and the direction of
/// the axis. Both links are off by `slack`, and that direction by `turn`: `kMeasured` slacks in
/// all, with room for a product. So a joint that turns a stretched arm about itself counts by its
/// width. The bound is `all` + `by_arm` |a|: the arm of a point is its distance from the origin of
/// its link. `stretch` of all poses is a factor, as each vector passes each pose once.
///
/// From the cell. `at` is the pose that is decided, and the cell rests at its own. `slack` is that
/// of state_motion.h, for the farthest corner of the body.
///
/// From a link. The map is L = inverse(P_B) P_A of the poses that are decided. Let E be twice the
/// sum of the lengths of A and B, and of the farthest corners of both bodies. An inverse and its
/// pose are off the identity by 36 u in an entry and by 90 u of the sum of the shift's coordinates.
/// So P_B puts L a beside P_A a by 108 u E + 270 u E. The product adds 10 u E and 16 u E, `apply`
/// 16 u E: 420 u E in length. P_A a is off the law by the slack of A, and X_B of L a is off P_B of
/// it by the slack of B for lengths up to E. `slack` is the sum of the three, 2^-42 E = 2048 u E
/// for the first, times the stretch of both. Poses that are decided are off by the slacks of A and
/// B.
///
/// Turns. A map is off a rotation by `off` of all poses that are factors, and by its rounding:
/// `turn` without values, 118 u for an inverse and a product. Half the difference of two maps is
/// off that of two rotations by as much; `turn_margin` is twice the sum.
///
/// \source Schwarzer, Saha and Latombe 2005 (lengths of ways by reach); curvatures are our own.
#pragma once

#include "soms/base/box.h"
#include "soms/motion/detail/motion_law.h"
#include "soms/robot/detail/state_motion.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace soms::detail {

/// A body of a link, seen from a body of the cell or of another link.
class ChainLaw final : public MotionLaw {
 public:
  /// Seen from the cell, of which a body rests at `resting`. Refers to `motion`.
  /// \errors As MotionLaw::set_margins.
  ChainLaw(const StateMotion& motion, std::uint32_t link, const Box& body, const Pose& resting);

  /// Seen from the link `other`.
  ChainLaw(const StateMotion& motion, std::uint32_t link, const Box& body, std::uint32_t other,
           const Box& body_of_other);

  [[nodiscard]] Pose at(double t) const override;

  [[nodiscard]] Curvature curvature(double ta, double tb) const override;

  [[nodiscard]] double arm(const Vec3& point) const override;

  [[nodiscard]] Twist twist_at(double t) const override;

  [[nodiscard]] Pose mover_at(double t) const override { return motion_->pose(link_, t); }

  [[nodiscard]] Pose other_at(double t) const override { return other_ ? frame_at(t) : resting_; }

  [[nodiscard]] Pose resting_pose() const override { return resting_; }

  [[nodiscard]] Pose frame_at(double t) const override;

  /// No joint between the two bodies changes its value.
  [[nodiscard]] bool rests() const { return rests_; }

 private:
  void bound_curvature();

  /// At least the distance of the link's origin from the axis of a joint, half way.
  [[nodiscard]] double distance_half_way(std::uint32_t joint) const;

  const StateMotion* motion_;
  std::uint32_t link_;
  std::optional<std::uint32_t> other_;
  Pose resting_;
  std::vector<ChainStep> steps_;  ///< from the frame to the link
  Curvature curvature_;
  bool rests_ = true;
};

}  // namespace soms::detail
