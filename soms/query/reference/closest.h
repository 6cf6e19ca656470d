/// \file
/// The brute-force twins of `closest`, `nearest_triangles` and `near_triangles`: every triangle, no
/// tree, whole numbers. What tests and `--verify` believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/closest.h"
#include "soms/query/signed_closest.h"

#include <vector>

namespace soms::reference {

/// Same meaning as `soms::closest`, without options. A triangle is left out only if the gap of its
/// box, rounded down, exceeds the distance of a corner, rounded up; of all others the squared
/// distance is a fraction of whole numbers. `cost.node_tests` counts gaps, `cost.triangle_tests`
/// triangles decided so, each an exact test.
/// \errors  As `soms::closest`.
/// \cost    O(n) box gaps, and some 10 us for each triangle that is left.
[[nodiscard]] Closest closest_by_brute_force(const Body& body, const Vec3& point);

/// The same with the side, by `contains_by_brute_force`: the twin of `closest` of a closed body.
/// \errors  As both.
[[nodiscard]] SignedClosest closest_by_brute_force(const ClosedBody& body, const Vec3& point);

/// A triangle and its distance from a point.
struct RankedTriangle {
  TriangleId triangle = 0;
  Bracket distance;  ///< the doubles next to it

  [[nodiscard]] bool operator==(const RankedTriangle&) const = default;
};

/// All triangles at most `at_most` from the point by exact distance, equally near ones by number.
/// \errors  As `soms::near_triangles`.
/// \cost    Some 10 us a triangle, and O(n log n) comparisons of fractions.
[[nodiscard]] std::vector<RankedTriangle> triangles_by_brute_force(const Body& body,
                                                                   const Vec3& point,
                                                                   double at_most);

}  // namespace soms::reference
