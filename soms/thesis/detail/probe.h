/// \file
/// The eye and the pen of a traversal: tests pairs, reports leaf pairs, and counts both.
#pragma once

#include "soms/thesis/pair_traversal.h"

#include <algorithm>
#include <span>

namespace soms::detail {

/// One traversal of two posed trees in progress.
class Probe {
 public:
  Probe(const PosedTree& a, const PosedTree& b, const TraversalVisitor& visitor)
      : nodes_a_(a.tree->nodes),
        nodes_b_(b.tree->nodes),
        boxes_a_(a.boxes),
        boxes_b_(b.boxes),
        visitor_(visitor) {}

  [[nodiscard]] const Node& node_a(std::uint32_t i) const { return nodes_a_[i]; }

  [[nodiscard]] const Node& node_b(std::uint32_t i) const { return nodes_b_[i]; }

  [[nodiscard]] bool leaves(NodePair p) const {
    return node_a(p.a).is_leaf() && node_b(p.b).is_leaf();
  }

  /// Tests the boxes of a pair.
  bool test(NodePair p) {
    ++counts.box_tests;
    if (visitor_.keep_going && counts.box_tests % kBoxTestsBetweenAsks == 0 &&
        !visitor_.keep_going()) {
      stopped_ = true;
    }
    const bool hit = overlaps(boxes_a_[p.a], boxes_b_[p.b]);
    if (visitor_.tested) {
      visitor_.tested(p, hit);
    }
    return hit;
  }

  /// Takes the last pair from the stack.
  NodePair pop(std::vector<NodePair>& stack) {
    counts.max_stack = std::max<std::uint64_t>(counts.max_stack, stack.size());
    const NodePair p = stack.back();
    stack.pop_back();
    note_entry(p);
    return p;
  }

  /// Enters a pair at a depth of nested calls.
  void enter(NodePair p, std::uint64_t nesting) {
    counts.max_stack = std::max(counts.max_stack, nesting);
    note_entry(p);
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

  /// The visitor requested a stop: nothing more may be reported.
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Volume that the boxes of a pair share; 0 where they touch or are apart.
  [[nodiscard]] double shared_volume(NodePair p) const;

  TraversalCounts counts;

 private:
  void note_entry(NodePair p) {
    ++counts.entered;
    if (visitor_.entered) {
      visitor_.entered(p);
    }
  }

  std::span<const Node> nodes_a_;
  std::span<const Node> nodes_b_;
  std::span<const Box> boxes_a_;
  std::span<const Box> boxes_b_;
  const TraversalVisitor& visitor_;
  bool stopped_ = false;
};

}  // namespace soms::detail
