/// \file
/// Triangles that nearly touch, and how near they are.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/base/vector.h"

#include <utility>

namespace soms::test {

/// Two triangles in the cube [-2, 2]^3 that touch but for rounding: a corner on a face, on an edge
/// or on a corner, or two edges that cross.
[[nodiscard]] std::pair<Triangle, Triangle> nearly_touching(Rng& rng);

/// An upper bound of the distance of two disjoint triangles: the distance of two points of theirs,
/// in general the nearest, in extended precision.
[[nodiscard]] double distance_bound(const Triangle& s, const Triangle& t);

/// Most that `pose.apply` rounds any corner of `t` by, as a length.
[[nodiscard]] double rounding_bound(const Pose& pose, const Triangle& t);

}  // namespace soms::test
