/// \file
/// How far a moving body may be from where numbers put it, and how far its points leave straight
/// lines: what every "free" of a motion rests on.
///
/// The law. In real numbers, a point a of the body is at
///   x(t) = w(t) + R(t) (a - c),
/// where w(t) runs from w0 to w1 at constant speed and R(t) is the rotation of q(t) = q0 + t d with
/// d = q1 - q0. The doubles q0, q1, w0, w1, c are those that RigidMotion holds. A straight motion
/// has x(t) = start.apply(a) + t by. Write u = 2^-53, B for the sum of the greatest |x|, |y|, |z|
/// of the body, C for that of the pivot, W for the greatest coordinate of w0 and w1. No coordinate
/// of x(t) exceeds B + C + W, as |a - c| is at most B + C; for a straight motion, the extent of the
/// start and of `by` together. Either is `reach` below.
///
/// Rounding of a pose. What `law_at(t)` does to a, as a real map and by `Pose::apply`, is off x(t)
/// by at most `slack` = 2^-45 reach + 2^-1060. For a turn that is the proof of motion_segment.cpp:
/// 48 u (B + C) + 12 u W for a coordinate, less than twice that for a point, 2^-45 = 256 u. For a
/// straight motion: by is multiplied and added with 2 u |by| + u |start|, and applied with 4 u of
/// the extent: 8 u reach for a coordinate. So `pose_at(t)` puts no point farther than `slack` from
/// x(t), at 0 < t < 1. At 0 and 1 it is the caller's pose, which may be stretched by 1e-6. There
/// the traversal proves nothing: the two poses are decided as they are, by `within`.
///
/// Chords. Let x(t) be followed over [ta, tb] of half length h about tm, and let
///   m(a) + s d(a), s = (t - tm) / h in [-1, 1],
/// be half the sum, and half the difference, of the real maps of `law_at(ta)` and `law_at(tb)`. A
/// chord of a curve is off the curve by at most (tb - ta)^2 / 8 max |x''|; each end is off by the
/// slack. x'' has no part of w. The body turns about one axis, at the distance r of a from it, by
/// the angle A(t), so |x''| <= r (A'^2 + |A''|), and
///   |x(t) - m(a) - s d(a)| <= slack + r curvature h^2 / 2.                                     (1)
/// This needs no velocity, and so no bound of how one is rounded. For a straight motion the
/// curvature is 0 and the chord is the path.
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
/// Boxes. A box of the body is {p + Q z: |z_i| <= h_i} and seen at s in [-1, 1] lies in
///   m(p) + s d(p) + M Q z + s D Q z,
/// M and D the matrices of m and d. |D Q z| <= |D| |z|. D is half a difference of two rotations
/// about one axis, whose two singular values above 0 are equal, so |D| is its Frobenius norm over
/// sqrt(2): rounding adds 120 u at most, `turn` adds 2^-44 = 512 u. Nothing depends on M being a
/// rotation, nor on the pose of the fixed body being one: a box of it is any parallelepiped.
///
/// Windows of times. Along a direction n of length 1 the boxes can share a point, or be within the
/// clearance, at s only if |n.(y - m(p)) - s n.d(p)| <= rx + ry + e, where rx and ry are the boxes'
/// radii along n and e adds all above, with the clearance. Both sides are linear in s: the times
/// are an interval. What rounding does to the left side and the radii, anywhere in [-1, 1], is
/// added to e. In units of u S, S = reach + the extent of the fixed body + the clearance:
/// centers in the body's coordinates, below 4 S, 50 after the turn; moved, 65; both, with d, three
/// times: 350. Products with n, whose entries sum up to 1.74 at most, 600, and 360 for their own
/// rounding. Radii 440, sums 80. Together below 1900; `box_margin` is 2^-40 S = 8192 u S.
/// Directions are of length 1 to 2^-50, and lengths in e get a factor 1 + 2^-40. Bounds are
/// quotients of numbers that stand for themselves: two roundings, |s| <= 1, below the 2^-48 that
/// windows grow. Axes of nodes are floats, orthonormal to 2^-23: radii grow by 2^-20 of the node's
/// radius.
///
/// Triangles. Corners at ta and tb are moved by `apply`. A gap along n, of length 1 to 2^-50, is
/// off by 20 u S at most: three products of differences below 2 S. With g the lesser of the gaps at
/// two times, (1) says that at no time between them the gap of x(t) is below
///   g - slack - 20 u S - r curvature h^2 / 2,
/// nor that of `pose_at(t)` by another slack. `pair_margin` is 2 slack + 2^-46 S = 128 u S more.
///
/// Underflow. Products of an entry up to 1 and a length are off by 2^-1075, of which no sum has
/// more than 2^10; `box_margin` and `pair_margin` end in 2^-1050, the slack in 2^-1060. A curvature
/// below 2^-200 is 0 in effect: times 2^301 it is less than what 2^-46 stands for.
///
/// Overflow. S is at most 2^301 (`out_of_range` beyond), no product has two lengths, and directions
/// are made of vectors that were scaled to 1 first.
#pragma once

#include "soms/motion/detail/quaternion.h"
#include "soms/motion/rigid_motion.h"
#include "soms/query/body.h"
#include "soms/tree/shape.h"

namespace soms::detail {

inline constexpr double kMotionUnit = 0x1p-53;

/// Covers the rounding of a handful of operations on numbers that are not negative.
inline constexpr double kMotionUp = 1 + 0x1p-40;

/// Shares of sizes in the margins of the proof, and what the proof needs of them.
inline constexpr double kSlackShare = 0x1p-45;
inline constexpr double kBoxShare = 0x1p-40;
inline constexpr double kPairShare = 0x1p-46;
inline constexpr double kTurnMargin = 0x1p-44;
inline constexpr double kSineMargin = 0x1p-46;
inline constexpr double kWindowMargin = 0x1p-48;
inline constexpr double kAxesShare = 0x1p-20;
inline constexpr double kTinySlack = 0x1p-1060;
inline constexpr double kTinyMargin = 0x1p-1050;

static_assert(kSlackShare >= 2 * 2 * 48 * kMotionUnit, "rounding of a pose, twice");
static_assert(kBoxShare >= 4 * 1900 * kMotionUnit, "rounding of boxes and windows, four times");
static_assert(kPairShare >= 4 * 20 * kMotionUnit, "rounding of gaps, four times");
static_assert(kTurnMargin >= 4 * 120 * kMotionUnit, "rounding of a difference of rotations");
static_assert(kSineMargin >= 4 * 16 * kMotionUnit, "rounding of a sine, four times");
static_assert(kWindowMargin >= 4 * 3 * kMotionUnit, "rounding of the ends of windows");
static_assert(kAxesShare >= 4 * 0x1p-23, "axes of nodes");

/// The bounds of one question.
class MotionBounds {
 public:
  /// \pre The poses passed their checks, no mesh is empty, `clearance` is not negative.
  /// \errors ErrorKind::out_of_range where the body may come beyond 2^300 on its way.
  MotionBounds(const Shape& mover, const RigidMotion& motion, const Body& fixed, double clearance);

  [[nodiscard]] const RigidMotion& motion() const { return *motion_; }

  [[nodiscard]] double clearance() const { return clearance_; }

  /// First contacts are decided exactly: the motion is straight, and a contact is a common point.
  [[nodiscard]] bool exact() const { return motion_->straight() && clearance_ == 0; }

  [[nodiscard]] double slack() const { return slack_; }

  /// Added to the reach of boxes: clearance, slack and rounding.
  [[nodiscard]] double box_margin() const { return box_margin_; }

  /// Gaps of triangles up to this prove nothing: clearance, slack and rounding.
  [[nodiscard]] double pair_margin() const { return pair_margin_; }

  /// The same without the clearance.
  [[nodiscard]] double rounding() const { return rounding_; }

  /// At least A'^2 + |A''| over [ta, tb].
  [[nodiscard]] double curvature(double ta, double tb) const;

  /// At least what a curve may leave its chord by, for each unit of the distance from the axis:
  /// between times that are `width` apart, over which the curvature is at most `curvature`.
  [[nodiscard]] static double bow(double curvature, double width) {
    return curvature * (width * width / 8) * kMotionUp;
  }

  /// At least the share of a bow that counts along a direction of length 1, at most 1.
  [[nodiscard]] double across(const Vec3& n) const;

  /// At least the distance of a point of the body from the axis.
  [[nodiscard]] double arm(const Vec3& point) const;

 private:
  const RigidMotion* motion_;
  double clearance_;
  Vec3 axis_;           ///< of length 1, in the body
  Vec3 axis_in_world_;  ///< likewise
  double sine_ = 0;     ///< rounded up
  Quaternion step_ = {};
  double reach_ = 0;
  double slack_ = 0;
  double box_margin_ = 0;
  double pair_margin_ = 0;
  double rounding_ = 0;
};

}  // namespace soms::detail
