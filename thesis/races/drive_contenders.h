/// \file
/// Rules and traversals that the experiments on drives compare.
#pragma once

#include "thesis/races/traversal_match.h"
#include "thesis/trips/frames.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace soms::reproduce {

/// E-Node as it suits a small object in a city, and the traversal after Larsson.
enum DriveTraversal : std::size_t { e_node_larger, larsson, drive_traversal_count };

[[nodiscard]] inline std::array<NamedTraversal, drive_traversal_count> drive_traversals() {
  return {{named_traversal("enode_larger"), {"larsson", {.traversal = Traversal::larsson}}}};
}

inline constexpr std::array<std::string_view, drive_traversal_count> kDriveTraversalTitles{
    "E-Node, larger node first", "Larsson's DFS"};

/// Names of the rules: that of the thesis, and the one it is compared with.
inline constexpr std::array<std::string_view, 2> kDriveRules{"soms", "spatial_median"};

/// Leaves that overlap hold too many pairs of triangles to test them all in every frame.
[[nodiscard]] inline bool has_too_many_pairs(const Totals& sum) {
  return sum.counts.triangle_pairs > kManyTrianglePairs;
}

}  // namespace soms::reproduce
