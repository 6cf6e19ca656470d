/// \file
/// The brute-force twins of `distance` and `within`: every pair of triangles, no tree, whole
/// numbers. What tests and `--verify` believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/distance.h"

namespace soms::reference {

/// Same meaning as `soms::distance`, without options. A pair of triangles is left out only if the
/// gap of their boxes, rounded down, exceeds the distance of two corners, rounded up; of all others
/// the squared distance is a fraction of whole numbers. `cost.node_tests` counts gaps,
/// `cost.triangle_tests` pairs decided so, each an exact test.
/// \errors  As `soms::distance`.
/// \cost    O(n m) box gaps, and some 50 us for each pair that is left.
[[nodiscard]] Distance distance_by_brute_force(const Body& a, const Body& b,
                                               const Limits& limits = {});

/// Whether the bodies are within `clearance`, as `soms::within` decides it.
/// \errors  As `soms::within`.
/// \cost    As `distance_by_brute_force` at worst.
[[nodiscard]] bool within_by_brute_force(const Body& a, const Body& b, double clearance,
                                         const Limits& limits = {});

}  // namespace soms::reference
