/// \file
/// The ends of a shortest segment between two triangles.
#pragma once

#include "soms/base/vector.h"

#include <array>

namespace soms::detail {

/// The middle of the points of `a` that are nearest to `b`, and the point of `b` next to it, as
/// `triangle_distance` says; for triangles with a point in common the middle of what they share,
/// twice.
/// \pre  Coordinates are finite and of magnitude at most 2^300.
/// \cost About 2 us; 10 us where there is more than one shortest segment.
[[nodiscard]] std::array<Vec3, 2> nearest_points(const Triangle& a, const Triangle& b);

}  // namespace soms::detail
