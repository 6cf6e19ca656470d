/// \file
/// Where a line passes the plane of a triangle, in floating point with proved bounds. What they
/// leave open, exact_ray.h decides.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/exact_ray.h"

#include <array>
#include <optional>

namespace soms::detail {

/// The direction of a ray in units of 2^exponent, such that its largest component is at least 1 and
/// below 2: `high + low`, which is exact where `exact` is set. Zero stays zero.
struct ScaledDirection {
  explicit ScaledDirection(const RayLine& line);

  std::array<DoubleDouble, 3> part;
  Vec3 high;
  int exponent = 0;
  bool exact = true;
};

/// Two doubles around a time, counted in units of a scaled direction, and the side that is met.
struct TimeBounds {
  double lower = 0;
  double upper = 0;
  int side = 0;  ///< as ExactRay::side
};

/// A time between neighboring doubles, the point, and the side that is met.
struct PlaneHit {
  Bracket t;
  Vec3 point;
  int side = 0;  ///< as ExactRay::side
};

/// Bounds of the time at which the line of a ray passes a plane, in about 20 ns; nothing where the
/// plane may be parallel to it.
///
/// The time is the quotient of two determinants, -n.(o - a) and n.d. Each is off by `error_bound`
/// of predicates.h at most. For n.d half as much is added, since the low part of d is at most 2^-53
/// of d, and the bound is 7 of those. The quotient's roundings are below 2^-50. Determinants that
/// underflow are predicates.h's; so no divisor is 0, and a quotient that does is off by 2^-1074.
[[nodiscard]] std::optional<TimeBounds> time_bounds(const RayLine& line,
                                                    const ScaledDirection& direction,
                                                    const Triangle& triangle);

/// The same in double-double: the neighboring doubles and the nearest point, where that suffices.
///
/// Differences of coordinates are exact. Terms of n.(a - o) pass four operations and those of the
/// sum two, each off by 2^-102 of the term: below 2^-98 of the sum of magnitudes; so is n.d. Low
/// parts that underflow are off by 2^-1074 and multiplied by 2^301 at most, as in predicates.h. A
/// way t d that underflows is off by less than 2^-100 of the point's coordinate, above 2^-900.
[[nodiscard]] std::optional<PlaneHit> plane_hit(const RayLine& line,
                                                const ScaledDirection& direction,
                                                const Triangle& triangle);

}  // namespace soms::detail
