/// \file
/// The brute-force twin of `contains`: every triangle, no tree. What tests and `--verify` believe.
#pragma once

#include "soms/base/vector.h"
#include "soms/query/body.h"
#include "soms/query/contains.h"

#include <span>
#include <vector>

namespace soms::reference {

/// Same meaning as `soms::contains` of a closed body, by another rule: `on` where the point, taken
/// as a triangle, overlaps one of the body's; else the parity of a slanted segment from the point
/// to beyond the body, which is chosen again until it meets no edge and lies in no triangle's
/// plane. All signs are those of `orientation`. Whether the body is closed is not checked. \errors
/// As for a query of the mesh at the pose. \cost    O(n) exact tests, for each point.
[[nodiscard]] Side contains_by_brute_force(const Body& body, const Vec3& point);

/// The same for points, in order; the body is moved once.
[[nodiscard]] std::vector<Side> contains_by_brute_force(const Body& body,
                                                        std::span<const Vec3> points);

}  // namespace soms::reference
