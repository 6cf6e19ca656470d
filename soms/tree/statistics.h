/// \file
/// Counts of a tree: what the thesis' tables 5.1 to 5.11 need, and the modern SAH cost.
#pragma once

#include "soms/tree/build_options.h"
#include "soms/tree/tree.h"

#include <cstdint>

namespace soms {

/// Counts of a tree; names as in the thesis' tables.
struct TreeStatistics {
  std::uint64_t nodes = 0;
  std::uint64_t leaves = 0;       ///< leaves that hold a triangle
  std::uint64_t one = 0;          ///< leaves with exactly one triangle
  std::uint64_t lt5 = 0;          ///< leaves with 1 to 4 triangles ("balance mode")
  std::uint64_t undividable = 0;  ///< nodes whose rule left one side empty
  std::uint64_t capped = 0;       ///< leaves at the last level with more than per_leaf triangles
  std::uint64_t empty = 0;        ///< nodes without triangles (EmptySide::chain)
  std::uint64_t depth = 0;        ///< greatest depth of a node; the root has 0
  std::uint64_t min_leaf_depth = 0;
  std::uint64_t max_leaf_depth = 0;
  std::uint64_t largest_leaf = 0;
  /// Greatest level L such that all 2^(L-1) nodes of depth L-1 exist and hold a triangle.
  std::uint64_t balanced_level = 0;

  [[nodiscard]] bool operator==(const TreeStatistics&) const = default;
};

/// Counts a tree that was built with `options` (they decide what counts as capped).
/// \source  thesis, tables 5.1 to 5.11; the balanced level is a reconstruction.
[[nodiscard]] TreeStatistics statistics(const Tree& tree, const BuildOptions& options);

/// Expected cost of a random ray or small box by surface area: inner nodes at 1, each triangle of a
/// leaf at `triangle_cost`, weighted by half_area(node) / half_area(root). 0 for an empty tree.
/// \source  Goldsmith and Salmon 1987; MacDonald and Booth 1990.
[[nodiscard]] double sah_cost(const Tree& tree, double triangle_cost = 1);

}  // namespace soms
