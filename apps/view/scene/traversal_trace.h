/// \file
/// What a traversal of two trees looked at: which boxes it visited, pruned and found.
#pragma once

#include "soms/base/box.h"
#include "soms/base/parallel.h"
#include "soms/thesis/pair_traversal.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversal_options.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// What became of a node in a traversal; of several pairs with it the greatest counts.
enum class Fate : std::uint8_t {
  untouched,  ///< never tested
  pruned,     ///< apart from every node it was tested against
  visited,    ///< overlapping one at least; its pair was descended
  found,      ///< a leaf of a pair that was found
};

/// Nodes of a tree by their fate.
struct FateCounts {
  std::uint64_t untouched = 0;
  std::uint64_t pruned = 0;
  std::uint64_t visited = 0;
  std::uint64_t found = 0;

  [[nodiscard]] bool operator==(const FateCounts&) const = default;
};

/// A traversal that was watched.
struct TraversalTrace {
  std::vector<Fate> a;  ///< one a node of the first tree; empty before the first traversal
  std::vector<Fate> b;  ///< one a node of the second
  TraversalCounts counts;
  std::uint64_t overlapping = 0;  ///< box tests that overlapped
  std::uint64_t apart = 0;        ///< box tests that did not
  std::uint64_t pruned = 0;       ///< box tests that ended a branch
  bool cut = false;               ///< ended at `most_tests`; there is more
  double milliseconds = 0;        ///< of the same traversal, not watched
};

/// Most box tests of a watched traversal: without pruning there are as many as pairs of nodes.
inline constexpr std::uint64_t kMostWatchedTests = 2'000'000;

/// Traverses two posed trees and notes the fate of each node.
/// \errors As `traverse`: ErrorKind::usage for Traversal::fast, which has no boxes of the trees;
///         ErrorKind::cancelled.
/// \cost   Two traversals, one of them with a call for each box test.
[[nodiscard]] TraversalTrace watch(const PosedTree& a, const PosedTree& b,
                                   const TraversalOptions& options,
                                   std::uint64_t most_tests = kMostWatchedTests,
                                   const Limits& limits = {});

[[nodiscard]] FateCounts count_fates(const std::vector<Fate>& fates);

}  // namespace soms::view
