/// \file
/// Where a ray meets a triangle, in whole numbers: nothing is rounded but what is given out.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/feature_pair.h"

#include <array>
#include <compare>
#include <cstddef>
#include <limits>

namespace soms::detail {

/// The points origin + t d with 0 <= t <= length, where d is `ahead`, or `ahead` - origin of a
/// segment, which is not rounded.
struct RayLine {
  Vec3 origin;
  Vec3 ahead;
  double length = std::numeric_limits<double>::infinity();
  bool segment = false;
};

/// above / below * 2^exponent.
struct RayTime {
  Integer above;
  Integer below = Integer(1);  ///< above 0
  int exponent = 0;
};

[[nodiscard]] std::strong_ordering compare(const RayTime& a, const RayTime& b);

/// How a time stands to `t`, which may be infinite.
[[nodiscard]] std::strong_ordering compare(const RayTime& a, double t);

/// The doubles next to a time that is not negative; beyond all doubles that is infinity.
[[nodiscard]] Bracket bracket(const RayTime& time);

/// A ray and a triangle on common grids: one of places, one of directions.
///
/// Relative to the origin, with d the direction and n the triangle's normal, d.n = 0 says that the
/// triangle is parallel to the ray or flat: then the ray's line meets it only where the volumes of
/// d and all three edges vanish, and line and triangle are clipped in a plane. Else line and
/// triangle meet in one point if no two volumes differ in sign, at t = n.a / n.d.
class ExactRay {
 public:
  /// \pre Numbers are finite, the direction is not zero unless it is a segment's, and places are
  /// within 2^301.
  ExactRay(const RayLine& line, const Triangle& triangle);

  /// The ray from the origin of a grid, and a triangle on it; the grids' units are 2^`place_unit`
  /// and 2^`direction_unit`. \pre The direction is not zero.
  ExactRay(const std::array<IntegerVec, 3>& corners, int place_unit, const IntegerVec& direction,
           int direction_unit, double length);

  /// The ray meets the triangle.
  [[nodiscard]] bool hit() const { return hit_; }

  /// The least t of a common point. \pre It is hit, as for all that follows.
  [[nodiscard]] const RayTime& time() const { return time_; }

  /// The point at that t, each coordinate rounded to the nearest double.
  [[nodiscard]] Vec3 point() const;

  /// 1 if the ray meets the side from which the corners turn counterclockwise, -1 the other, 0 if
  /// the triangle is parallel to it or has no area.
  [[nodiscard]] int side() const { return -steepness_; }

  /// The least corners, edges or the face that hold the point: one, or several where the triangle
  /// has no area. Features that are not used are 0.
  [[nodiscard]] std::array<Feature, 3> features() const;

  /// A line beside the ray's crosses the triangle: the ray's, moved by (e, e^2, e^3) for a positive
  /// e that is less than anything here. False where `side` is 0.
  /// \source Edelsbrunner and Muecke 1990, Simulation of Simplicity, section 4.
  [[nodiscard]] bool crossed_beside() const;

 private:
  [[nodiscard]] IntegerVec edge(std::size_t i) const;
  void meet(double length);
  void meet_within(const IntegerVec& normal, double length);
  void meet_point(const IntegerVec& normal);
  [[nodiscard]] RayTime time_of(Integer above, Integer below) const;
  [[nodiscard]] bool is_at(std::size_t corner) const;
  [[nodiscard]] bool is_within(std::size_t edge) const;

  std::array<IntegerVec, 3> corner_;  // from the origin
  IntegerVec origin_;
  IntegerVec direction_;
  int place_unit_ = 0;  // log2 of the grids' units
  int direction_unit_ = 0;
  std::array<Integer, 3> volume_;  // of the direction and an edge, from the origin
  int steepness_ = 0;              // sign of the product of direction and normal
  bool hit_ = false;
  RayTime time_;
};

}  // namespace soms::detail
