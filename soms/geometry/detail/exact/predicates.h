/// \file
/// The predicates with a filter in front, and a note whether the filter sufficed.
#pragma once

#include "soms/base/double_limits.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/orientation_exact.h"
#include "soms/geometry/detail/projection.h"
#include "soms/geometry/orientation.h"

#include <cmath>

namespace soms::detail {

/// Shewchuk's stage-A bounds, relative to the same formula with absolute values ("permanent").
inline constexpr double kBound3d = (7 + 56 * kRoundingUnit) * kRoundingUnit;
inline constexpr double kBound2d = (3 + 16 * kRoundingUnit) * kRoundingUnit;

/// Room for underflow. A product of two that underflows is off by at most 2^-1075 and is scaled by
/// at most 2^301 afterwards; with six such terms, twice (determinant and permanent), the error
/// stays below 2^-769.
inline constexpr double kUnderflow = 0x1p-760;

/// What the plane through a triangle needs to tell sides: the cross product of two of its edges,
/// and the same with absolute values.
struct Plane {
  Vec3 origin;
  Vec3 normal;
  Vec3 magnitude;

  Plane(const Vec3& a, const Vec3& b, const Vec3& c) : origin(a) {
    const Vec3 u = b - a;
    const Vec3 v = c - a;
    const double yz = u.y * v.z;
    const double zy = u.z * v.y;
    const double zx = u.z * v.x;
    const double xz = u.x * v.z;
    const double xy = u.x * v.y;
    const double yx = u.y * v.x;
    normal = {yz - zy, zx - xz, xy - yx};
    magnitude = {std::abs(yz) + std::abs(zy), std::abs(zx) + std::abs(xz),
                 std::abs(xy) + std::abs(yx)};
  }
};

/// Bound on the error of `dot(plane.normal, w)` for all `w` with |w| at most `reach` on each axis.
[[nodiscard]] inline double error_bound(const Plane& plane, const Vec3& reach) {
  return kBound3d * dot(plane.magnitude, reach) + kUnderflow;
}

/// Signs of determinants; `exact` records whether a filter left one open.
struct Predicates {
  bool exact = false;

  /// As `soms::orientation`.
  [[nodiscard]] Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Plane plane(a, b, c);
    const Vec3 w = d - a;
    const double det = dot(plane.normal, w);
    const double bound = error_bound(plane, {std::abs(w.x), std::abs(w.y), std::abs(w.z)});
    if (det > bound) {
      return Sign::positive;
    }
    if (det < -bound) {
      return Sign::negative;
    }
    exact = true;
    return orientation_exact(a, b, c, d);
  }

  /// As `soms::orientation2d`.
  [[nodiscard]] Sign orientation2d(const Vec3& a, const Vec3& b, const Vec3& c, Projection plane) {
    const double left = (first_coordinate(b, plane) - first_coordinate(a, plane)) *
                        (second_coordinate(c, plane) - second_coordinate(a, plane));
    const double right = (second_coordinate(b, plane) - second_coordinate(a, plane)) *
                         (first_coordinate(c, plane) - first_coordinate(a, plane));
    const double det = left - right;
    const double bound = kBound2d * (std::abs(left) + std::abs(right)) + kUnderflow;
    if (det > bound) {
      return Sign::positive;
    }
    if (det < -bound) {
      return Sign::negative;
    }
    exact = true;
    return orientation2d_exact(a, b, c, plane);
  }
};

}  // namespace soms::detail
