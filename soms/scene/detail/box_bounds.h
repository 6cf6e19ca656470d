/// \file
/// How near is a box to a point or another box, and where does a ray enter it? Rounded so that
/// nothing in the box is nearer, or earlier, than what is said.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <limits>

namespace soms::detail {

/// The key of a box that a ray misses.
inline constexpr double kNoEntry = std::numeric_limits<double>::infinity();

/// Not above the distance of `point` from any point of `box`; 0 inside.
/// \pre The box is not empty; coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] double distance_at_least(const Vec3& point, const Box& box);

/// Not above the distance of any point of one box from any point of the other; 0 where they meet.
/// \pre As above, for both.
[[nodiscard]] double distance_at_least(const Box& a, const Box& b);

/// Not above any t >= 0 for which origin + t direction is in `box`; `kNoEntry` if there is none.
/// `direction` may be the rounded difference of two points, the exact one being meant.
/// \pre As above for origin and box; the direction is finite. Where it is 0, the ray is the point.
[[nodiscard]] double entry_at_least(const Vec3& origin, const Vec3& direction, const Box& box);

}  // namespace soms::detail
