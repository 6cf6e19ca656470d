/// \file
/// One case under every variation that may not change its answer.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include <functional>
#include <string>
#include <vector>

namespace soms::test {

/// A case in another form, which changes an answer by no more than renaming and scaling.
struct Variation {
  std::string what;
  Body a;
  Body b;
  Limits limits = {};
  bool exchanged = false;  ///< `a` is of the second mesh
  /// Where the triangles of each body went; empty where all stayed.
  std::vector<TriangleId> place_a = {};
  std::vector<TriangleId> place_b = {};
  int exponent = 0;  ///< lengths are 2^exponent as long, exactly
};

/// Calls `check` with two meshes (world coordinates) as given and under each of these variations,
/// one at a time:
/// - vertices: the 24 rotations of the cube (on the vertices, and as poses of both); scaling by
///   2^k, k = -40 to 40; a shift by (2^20, -2^21, 2^19); the latter two where they round nothing;
/// - order: arguments swapped, triangles and corners permuted;
/// - machinery: every rule and layout with leaves of 1, 4 and 1000; 1, 2 and 8 threads.
void for_each_variation(const Mesh& a, const Mesh& b,
                        const std::function<void(const Variation&)>& check);

/// Poses of a batch of 1000 for the first of two meshes, of which number `kPlaceInBatch` is the
/// identity; the others only fill the batch.
inline constexpr std::size_t kPlaceInBatch = 777;
[[nodiscard]] std::vector<Pose> poses_around(const Mesh& a);

/// Asks for the overlap of two meshes under all variations, and by every named traversal, in modes
/// any and first, and as one of 1000 batched poses, and expects the list of the brute-force twin,
/// renamed where the variation renames. Returns that list.
std::vector<TrianglePair> overlap_under_variations(const Mesh& a, const Mesh& b);

/// As above, and expects the list to be empty or not.
void expect_overlap(const Mesh& a, const Mesh& b, bool expected);

/// Asks for the distance of two meshes, and whether they are within it and within less, under all
/// variations and as one of 1000 batched poses, and expects the answer of the brute-force twin,
/// scaled where the variation scales. Returns that answer.
Distance distance_under_variations(const Mesh& a, const Mesh& b);

/// As above, and expects this distance.
void expect_distance(const Mesh& a, const Mesh& b, const Bracket& expected);

}  // namespace soms::test
