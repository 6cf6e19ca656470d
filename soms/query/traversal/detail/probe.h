/// \file
/// The eye and the pen of a traversal: tests pairs, reports leaf pairs, and counts both.
#pragma once

#include "soms/query/traversal/pair_traversal.h"

#include <algorithm>

namespace soms::detail {

/// One traversal of two posed trees in progress.
class Probe {
 public:
  Probe(const PosedTree& a, const PosedTree& b, const TraversalVisitor& visitor)
      : a_(a), b_(b), visitor_(visitor) {}

  [[nodiscard]] const Node& node_a(std::uint32_t i) const { return a_.tree->nodes[i]; }

  [[nodiscard]] const Node& node_b(std::uint32_t i) const { return b_.tree->nodes[i]; }

  [[nodiscard]] bool leaves(NodePair p) const {
    return node_a(p.a).is_leaf() && node_b(p.b).is_leaf();
  }

  /// Tests the boxes of a pair.
  bool test(NodePair p) {
    ++counts.box_tests;
    if (visitor_.keep_going && counts.box_tests % kInterval == 0 && !visitor_.keep_going()) {
      stopped_ = true;
    }
    return overlaps(a_.boxes[p.a], b_.boxes[p.b]);
  }

  /// Reports an overlapping pair of leaves.
  void report(NodePair p) {
    if (counts.leaf_pairs++ == 0) {
      counts.first_tests = counts.box_tests;
    }
    counts.triangle_pairs += std::uint64_t{node_a(p.a).count} * node_b(p.b).count;
    if (visitor_.leaf_pair && !visitor_.leaf_pair(p)) {
      stopped_ = true;
    }
  }

  void note_stack(std::size_t size) {
    counts.max_stack = std::max<std::uint64_t>(counts.max_stack, size);
  }

  /// The visitor asked to stop: nothing more may be reported.
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Volume that the boxes of a pair share; 0 where they touch or are apart.
  [[nodiscard]] double shared_volume(NodePair p) const;

  TraversalCounts counts;

 private:
  static constexpr std::uint64_t kInterval = 1024;

  const PosedTree& a_;
  const PosedTree& b_;
  const TraversalVisitor& visitor_;
  bool stopped_ = false;
};

}  // namespace soms::detail
