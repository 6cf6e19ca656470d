#include "soms/query/traversal/e_node_front.h"

#include "soms/query/traversal/detail/child_pairs.h"
#include "soms/query/traversal/detail/e_node_step.h"
#include "soms/query/traversal/detail/probe.h"
#include "soms/query/traversal/traversals.h"

#include <algorithm>
#include <unordered_map>

namespace soms {

namespace {

std::vector<std::uint32_t> parents(const Tree& tree) {
  std::vector<std::uint32_t> out(tree.nodes.size(), Node::kNone);
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    if (!tree.nodes[i].is_leaf()) {
      out[tree.nodes[i].left] = i;
      out[tree.nodes[i].right] = i;
    }
  }
  return out;
}

bool is_root(NodePair p) {
  return p == NodePair{};
}

}  // namespace

EnodeFront::EnodeFront(const Tree& a, const Tree& b, Descent descent, EntryOrder order)
    : a_(&a), b_(&b), parents_a_(parents(a)), parents_b_(parents(b)) {
  options_.traversal = Traversal::e_node_front;
  options_.descent = descent;
  options_.order = order;
  check(options_);
  restart();
}

void EnodeFront::restart() {
  front_.clear();
  if (!a_->nodes.empty() && !b_->nodes.empty()) {
    front_.push_back(NodePair{});
  }
}

// The pair from which the descent reaches `p`, from the trees alone. Descent both keeps depths
// equal until it meets a leaf. Descent larger opens all ancestors of both nodes in the order of
// their volumes, the first tree's first in a tie, and volumes never grow downwards (rounded
// extents and products are monotone); so it opened the parent of lesser volume last.
NodePair EnodeFront::parent(NodePair p) const {
  const std::uint32_t up_a = parents_a_[p.a];
  const std::uint32_t up_b = parents_b_[p.b];
  if (up_a == Node::kNone || up_b == Node::kNone) {
    return up_a == Node::kNone ? NodePair{p.a, up_b} : NodePair{up_a, p.b};
  }
  if (options_.descent == Descent::larger) {
    const bool a_opened_before = detail::first_is_larger(a_->nodes[up_a], b_->nodes[up_b]);
    return a_opened_before ? NodePair{p.a, up_b} : NodePair{up_a, p.b};
  }
  const std::uint32_t depth_a = a_->nodes[p.a].depth;
  const std::uint32_t depth_b = b_->nodes[p.b].depth;
  return {depth_a >= depth_b ? up_a : p.a, depth_b >= depth_a ? up_b : p.b};
}

std::size_t EnodeFront::child_count(NodePair p) const {
  const bool both_inner = !a_->nodes[p.a].is_leaf() && !b_->nodes[p.b].is_leaf();
  return options_.descent == Descent::both && both_inner ? 4 : 2;
}

TraversalCounts EnodeFront::next(std::span<const Box> boxes_a, std::span<const Box> boxes_b,
                                 const TraversalVisitor& visitor) {
  const PosedTree a{a_, boxes_a};
  const PosedTree b{b_, boxes_b};
  detail::check_boxes(a, b);
  detail::Probe probe(a, b, visitor);
  std::vector<NodePair> next_front;
  next_front.reserve(front_.size());
  std::vector<Family> families;  // in order of first appearance
  std::unordered_map<std::uint64_t, std::size_t> family_of;
  stack_.clear();
  std::size_t done = 0;
  for (; done < front_.size() && !probe.stopped(); ++done) {
    const NodePair p = front_[done];
    if (!probe.test(p)) {
      if (is_root(p)) {
        next_front.push_back(p);
        continue;
      }
      const NodePair up = parent(p);
      const auto [at, fresh] =
          family_of.try_emplace(std::uint64_t{up.a} << 32 | up.b, families.size());
      if (fresh) {
        families.push_back({up, {}});
      }
      families[at->second].apart.push_back(p);
    } else if (probe.leaves(p)) {
      next_front.push_back(p);
      if (!probe.stopped()) {
        probe.report(p);
      }
    } else {
      stack_.push_back(p);
    }
  }
  std::reverse(stack_.begin(), stack_.end());
  detail::enter_all(probe, options_, stack_, &next_front);
  for (const Family& family : families) {
    const bool rises = !probe.stopped() && family.apart.size() == child_count(family.parent) &&
                       !probe.test(family.parent);
    if (rises) {
      next_front.push_back(family.parent);
    } else {
      next_front.insert(next_front.end(), family.apart.begin(), family.apart.end());
    }
  }
  // Only where the visitor stopped: what was not looked at, or not entered, stays in the front.
  next_front.insert(next_front.end(), stack_.rbegin(), stack_.rend());
  next_front.insert(next_front.end(), front_.begin() + static_cast<std::ptrdiff_t>(done),
                    front_.end());
  front_.swap(next_front);
  return probe.counts;
}

namespace detail {

TraversalCounts e_node_front(const PosedTree& a, const PosedTree& b,
                             const TraversalOptions& options, const TraversalVisitor& visitor,
                             TraversalWorkspace& /*workspace*/) {
  EnodeFront front(*a.tree, *b.tree, options.descent, options.order);
  return front.next(a.boxes, b.boxes, visitor);
}

}  // namespace detail

}  // namespace soms
