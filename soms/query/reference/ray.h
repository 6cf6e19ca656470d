/// \file
/// The brute-force twins of `closest_hit` and `all_hits`: every triangle, no tree, whole numbers.
/// What tests and `--verify` believe.
#pragma once

#include "soms/query/body.h"
#include "soms/query/ray.h"

#include <optional>

namespace soms::reference {

/// Same meaning as `soms::closest_hit`, without a deadline. `cost.exact_tests` counts triangles.
/// \errors  As for a query of the mesh at the pose; rays are not checked.
/// \cost    Some microseconds a triangle.
[[nodiscard]] ClosestHit closest_hit_by_brute_force(const Body& body, const Ray& ray,
                                                    std::optional<TriangleId> skip = std::nullopt);

/// Same meaning as `soms::all_hits` of one ray, without a deadline.
/// \cost    Some microseconds a triangle, and O(k^2) comparisons for k triangles met.
[[nodiscard]] AllHits all_hits_by_brute_force(const Body& body, const Ray& ray,
                                              std::optional<TriangleId> skip = std::nullopt);

}  // namespace soms::reference
