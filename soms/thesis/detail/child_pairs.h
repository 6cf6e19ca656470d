/// \file
/// Which pairs of children follow a pair of nodes: the rules that all traversals share.
#pragma once

#include "soms/thesis/detail/probe.h"
#include "soms/thesis/traversal_options.h"

#include <array>

namespace soms::detail {

/// Up to four pairs, in order.
class ChildPairs {
 public:
  void add(NodePair p) { pairs_[size_++] = p; }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] NodePair operator[](std::size_t i) const { return pairs_[i]; }

  [[nodiscard]] NodePair* begin() { return pairs_.data(); }

  [[nodiscard]] NodePair* end() { return pairs_.data() + size_; }

  [[nodiscard]] const NodePair* begin() const { return pairs_.data(); }

  [[nodiscard]] const NodePair* end() const { return pairs_.data() + size_; }

 private:
  std::array<NodePair, 4> pairs_{};
  std::size_t size_ = 0;
};

/// Children of both nodes, left before right, the first tree's slower: LL, LR, RL, RR. A leaf
/// stands for itself. \pre Not two leaves.
[[nodiscard]] inline ChildPairs descend_both(const Probe& probe, NodePair p) {
  const Node& a = probe.node_a(p.a);
  const Node& b = probe.node_b(p.b);
  ChildPairs out;
  for (const std::uint32_t i : {a.left, a.right}) {
    const std::uint32_t child_a = a.is_leaf() ? p.a : i;
    if (b.is_leaf()) {
      out.add({child_a, p.b});
    } else {
      out.add({child_a, b.left});
      out.add({child_a, b.right});
    }
    if (a.is_leaf()) {
      break;
    }
  }
  return out;
}

/// Children of the first node, each with the second. \pre The first node is inner.
[[nodiscard]] inline ChildPairs descend_a(const Probe& probe, NodePair p) {
  ChildPairs out;
  out.add({probe.node_a(p.a).left, p.b});
  out.add({probe.node_a(p.a).right, p.b});
  return out;
}

/// Children of the second node, each with the first. \pre The second node is inner.
[[nodiscard]] inline ChildPairs descend_b(const Probe& probe, NodePair p) {
  ChildPairs out;
  out.add({p.a, probe.node_b(p.b).left});
  out.add({p.a, probe.node_b(p.b).right});
  return out;
}

/// Does rule `larger` descend the first of two inner nodes? By the volumes of the boxes *before*
/// they were moved, so that equal trees compare equal in every pose; a tie descends the first.
[[nodiscard]] inline bool first_is_larger(const Node& a, const Node& b) {
  return volume(a.bounds) >= volume(b.bounds);
}

/// Child pairs of a pair by the rule of a baseline. \pre Not two leaves.
/// \source Ericson 2005, section 6.3.2 for the rules but `alternate`, which is a reconstruction.
[[nodiscard]] inline ChildPairs child_pairs(const Probe& probe, NodePair p, Traversal rule) {
  const Node& a = probe.node_a(p.a);
  const Node& b = probe.node_b(p.b);
  if (rule == Traversal::simultaneous) {
    return descend_both(probe, p);
  }
  if (a.is_leaf() || b.is_leaf()) {
    return b.is_leaf() ? descend_a(probe, p) : descend_b(probe, p);
  }
  const bool first = rule == Traversal::a_first ||
                     (rule == Traversal::alternate && a.depth <= b.depth) ||
                     (rule == Traversal::larger && first_is_larger(a, b));
  return first ? descend_a(probe, p) : descend_b(probe, p);
}

}  // namespace soms::detail
