/// \file
/// The ends of a shortest segment between two triangles.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/distance_ends.h"
#include "soms/geometry/detail/exact/double_double.h"

#include <array>

namespace soms::detail {

/// The ends of the only shortest segment, between features that are proved (FeatureProof::steady):
/// of what `end_points` found about a corner of `a`, with that exponent. Off by less than 2^-60 of
/// the largest difference: shares of edges are quotients whose parts are off by 2^9 u times their
/// lengths, u = 2^-102, and whose lower part is 2^-30 of them at least.
[[nodiscard]] std::array<Vec3, 2> in_world(const EndPoints<DoubleDouble>& points, int exponent,
                                           const Triangle& a);

/// The middle of the points of `a` that are nearest to `b`, and the point of `b` next to it, as
/// `triangle_distance` says; for triangles with a point in common the middle of what they share,
/// twice.
/// \pre  Coordinates are finite and of magnitude at most 2^300.
/// \cost About 2 us; 10 us where there is more than one shortest segment.
[[nodiscard]] std::array<Vec3, 2> nearest_points(const Triangle& a, const Triangle& b);

}  // namespace soms::detail
