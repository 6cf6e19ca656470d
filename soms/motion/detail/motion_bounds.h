/// \file
/// How far a moving body may be from where numbers put it, and how far its points leave straight
/// lines: what every "free" of a motion rests on.
///
/// A MotionLaw says where a point a of the mover is, x(t), in the frame of the other body, and
/// where numbers put it. Write u = 2^-53, and S = reach + the extent of the other body + the
/// clearance. At 0 and 1 poses are the caller's, which may be stretched by 1e-6. There the
/// traversal proves nothing: the two times are decided as they are, by `within`.
///
/// Chords. Let x(t) be followed over [ta, tb] of half length h about tm, and let
///   m(a) + s d(a), s = (t - tm) / h in [-1, 1],
/// be half the sum, and half the difference, of the real maps of the law at ta and tb. A chord of a
/// curve is off the curve by at most (tb - ta)^2 / 8 max |x''|; each end is off by the slack. So
///   |x(t) - m(a) - s d(a)| <= slack + curvature h^2 / 2.                                       (1)
/// Along a direction n the part of x'' along n counts alone, `across` of it. This needs no
/// velocity, and so no bound of how one is rounded. Where the curvature is 0 the chord is the path.
///
/// Boxes. A box of the body is {p + Q z: |z_i| <= h_i} and seen at s in [-1, 1] lies in
///   m(p) + s d(p) + M Q z + s D Q z,
/// M and D the matrices of m and d. |D Q z| <= |D| |z|. D is half a difference of two rotations.
/// One turned back by the other is a rotation about one axis, so D has two equal singular values
/// above 0, and |D| is its Frobenius norm over sqrt(2). Where one of the caller's poses is a
/// factor, which may be stretched by 1.5e-6, `kStretch` covers that. The law's `turn_margin` covers
/// rounding. Nothing depends on M being a rotation, nor on the pose of the other body being one: a
/// box of it is any parallelepiped.
///
/// Windows of times. Along a direction n of length 1 the boxes can share a point, or be within the
/// clearance, at s only if |n.(y - m(p)) - s n.d(p)| <= rx + ry + e, where rx and ry are the boxes'
/// radii along n and e adds all above, with the clearance. Both sides are linear in s: the times
/// are an interval. What rounding does to the left side and the radii, anywhere in [-1, 1], is
/// added to e. In units of u S: centers in the body's coordinates, below 4 S, 50 after the turn;
/// moved, 65; both, with d, three times: 350. Products with n, whose entries sum up to 1.74 at
/// most, 600, and 360 for their own rounding. Radii 440, sums 80. Together below 1900, and 1792 for
/// what triangle_windows.h says of edges; `box_margin` is 2^-40 S = 8192 u S. Directions are of
/// length 1 to 2^-50, and lengths in e get a factor 1 + 2^-40. Bounds are products of numbers that
/// stand for themselves and a rounded inverse: three roundings, |s| <= 1, below the 2^-48 that
/// windows grow. Axes of nodes are floats, orthonormal to 2^-23: radii grow by 2^-20 of the node's
/// radius.
///
/// Triangles of a leaf. They lie in its box, and arms of points differ by no more than the points
/// do: what a box of the leaf leaves its chord by holds for all of them.
///
/// Steps. Corners at ta and tb are moved by `apply`. A gap along n, of length 1 to 2^-50, is
/// off by 20 u S at most: three products of differences below 2 S. With g the lesser of the gaps at
/// two times, (1) says that at no time between them the gap of x(t) is below
///   g - slack - 20 u S - curvature h^2 / 2,
/// nor that of the poses that are decided by another slack. `pair_margin` is 2 slack + 2^-46 S =
/// 128 u S more.
///
/// Gaps below that are decided for x(t) itself, in whole numbers (exact_motion.h), where one body
/// moves and there is no clearance. Of poses nothing is proved then but those that are looked at.
///
/// Underflow. Products of an entry up to 1 and a length are off by 2^-1075, of which no sum has
/// more than 2^10; `box_margin` and `pair_margin` end in 2^-1050.
///
/// Overflow. S is at most 2^301 (`out_of_range` beyond), no product has two lengths, and directions
/// are made of vectors that were scaled to 1 first.
#pragma once

#include "soms/motion/detail/motion_law.h"
#include "soms/motion/detail/rigid_law.h"
#include "soms/tree/shape.h"

namespace soms::detail {

/// Shares of sizes in the margins of the proof, and what the proof needs of them.
inline constexpr double kBoxShare = 0x1p-40;
inline constexpr double kPairShare = 0x1p-46;
inline constexpr double kWindowMargin = 0x1p-48;
inline constexpr double kAxesShare = 0x1p-20;
inline constexpr double kTinyMargin = 0x1p-1050;

static_assert(kBoxShare >= 2 * (1900 + 1792) * kMotionUnit, "rounding of windows, twice");
static_assert(kPairShare >= 4 * 20 * kMotionUnit, "rounding of gaps, four times");
static_assert(kWindowMargin >= 4 * 3 * kMotionUnit, "rounding of the ends of windows");
static_assert(kAxesShare >= 4 * 0x1p-23, "axes of nodes");

/// The margins of one question.
class MotionBounds {
 public:
  /// Refers to the law.
  /// \pre No mesh is empty, `clearance` is not negative.
  MotionBounds(const MotionLaw& law, const Shape& other, double clearance);

  [[nodiscard]] const MotionLaw& law() const { return *law_; }

  [[nodiscard]] double clearance() const { return clearance_; }

  /// First contacts are decided exactly: the motion is straight, and a contact is a common point.
  [[nodiscard]] bool exact() const { return by_law() && law_->alone()->straight(); }

  /// Whether triangles touch can be decided by the law in real numbers: one body moves, and a
  /// contact is a common point.
  [[nodiscard]] bool by_law() const { return clearance_ == 0 && law_->alone() != nullptr; }

  /// Added to the reach of boxes: clearance, slack and rounding.
  [[nodiscard]] double box_margin() const { return box_margin_; }

  /// Gaps of triangles up to this prove nothing: clearance, slack and rounding.
  [[nodiscard]] double pair_margin() const { return pair_margin_; }

  /// The same without the clearance.
  [[nodiscard]] double rounding() const { return rounding_; }

  /// At least what a curve may leave its chord by, between times that are `width` apart.
  template <class Number>
  [[nodiscard]] static Number bow(const Number& curvature, double width) {
    return curvature * ((width * width / 8) * kMotionUp);
  }

 private:
  const MotionLaw* law_;
  double clearance_;
  double box_margin_ = 0;
  double pair_margin_ = 0;
  double rounding_ = 0;
};

}  // namespace soms::detail
