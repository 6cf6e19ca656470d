/// \file
/// One overlap case under every variation that may not change its answer.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"

#include <vector>

namespace soms::test {

/// Asks for the overlap of two meshes (world coordinates) under each of these variations, one at a
/// time, and expects the list of the brute-force twin, renamed where the variation renames:
/// - vertices: the 24 rotations of the cube (on the vertices, and as poses of both); scaling by
///   2^k, k = -40 to 40; a shift by (2^20, -2^21, 2^19); the latter two where they round nothing;
/// - order: arguments swapped, triangles and corners permuted;
/// - machinery: every rule with leaves of 1, 4 and 1000, every named traversal, 1, 2 and 8 threads,
///   modes any and first, alone and as one of 1000 batched poses.
/// Returns that list.
std::vector<TrianglePair> overlap_under_variations(const Mesh& a, const Mesh& b);

/// As above, and expects the list to be empty or not.
void expect_overlap(const Mesh& a, const Mesh& b, bool expected);

}  // namespace soms::test
