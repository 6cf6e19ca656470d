#include "soms/thesis/e_node_front.h"

#include "soms/base/arithmetic.h"
#include "soms/thesis/detail/child_pairs.h"
#include "soms/thesis/detail/e_node_step.h"
#include "soms/thesis/detail/probe.h"
#include "soms/thesis/traversals.h"

#include <algorithm>
#include <bit>

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
// equal until it meets a leaf. Descent larger descends all ancestors of both nodes in the order of
// their volumes, the first tree's first in a tie, and volumes never grow downwards (rounded
// extents and products are monotone); so it descended the parent of lesser volume last.
NodePair EnodeFront::parent(NodePair p) const {
  const std::uint32_t up_a = parents_a_[p.a];
  const std::uint32_t up_b = parents_b_[p.b];
  if (up_a == Node::kNone || up_b == Node::kNone) {
    return up_a == Node::kNone ? NodePair{p.a, up_b} : NodePair{up_a, p.b};
  }
  if (options_.descent == Descent::larger) {
    const bool a_descended_before = detail::first_is_larger(a_->nodes[up_a], b_->nodes[up_b]);
    return a_descended_before ? NodePair{p.a, up_b} : NodePair{up_a, p.b};
  }
  const std::uint32_t depth_a = a_->nodes[p.a].depth;
  const std::uint32_t depth_b = b_->nodes[p.b].depth;
  return {depth_a >= depth_b ? up_a : p.a, depth_b >= depth_a ? up_b : p.b};
}

std::size_t EnodeFront::child_count(NodePair p) const {
  const bool both_inner = !a_->nodes[p.a].is_leaf() && !b_->nodes[p.b].is_leaf();
  return options_.descent == Descent::both && both_inner ? 4 : 2;
}

void EnodeFront::Families::clear(std::size_t most) {
  list_.clear();
  const unsigned bits = std::max(4U, static_cast<unsigned>(std::bit_width(2 * most)));
  shift_ = 64 - bits;
  slots_.assign(std::size_t{1} << bits, Node::kNone);
}

void EnodeFront::Families::add(NodePair parent, NodePair apart) {
  const std::uint64_t key = std::uint64_t{parent.a} << 32 | parent.b;
  std::size_t slot = (key * 0x9e3779b97f4a7c15ULL) >> shift_;  // Fibonacci hashing
  while (slots_[slot] != Node::kNone && !(list_[slots_[slot]].parent == parent)) {
    slot = (slot + 1) & (slots_.size() - 1);
  }
  if (slots_[slot] == Node::kNone) {
    slots_[slot] = static_cast<std::uint32_t>(list_.size());
    list_.push_back({parent});
  }
  Family& family = list_[slots_[slot]];
  family.apart[family.count++] = apart;
}

// Apart: to its family. Two leaves: reported, and kept. Else: to the stack, the first on top.
void EnodeFront::test_front(detail::Probe& probe) {
  stack_.clear();
  families_.clear(front_.size());
  std::size_t done = 0;
  for (; done < front_.size() && !probe.stopped(); ++done) {
    const NodePair p = front_[done];
    if (!probe.test(p)) {
      if (is_root(p)) {
        next_front_.push_back(p);
      } else {
        families_.add(parent(p), p);
      }
    } else if (probe.leaves(p)) {
      next_front_.push_back(p);
      if (!probe.stopped()) {
        probe.report(p);
      }
    } else {
      stack_.push_back(p);
    }
  }
  std::reverse(stack_.begin(), stack_.end());
  // Only where the visitor stopped: what was not looked at stays.
  next_front_.insert(next_front_.end(), front_.begin() + static_cast<std::ptrdiff_t>(done),
                     front_.end());
}

// A parent takes the place of its child pairs where all of them are apart and so is the parent.
void EnodeFront::rise(detail::Probe& probe) {
  for (const Family& family : families_.list()) {
    if (!probe.stopped() && family.count == child_count(family.parent) &&
        !probe.test(family.parent)) {
      next_front_.push_back(family.parent);
    } else {
      next_front_.insert(next_front_.end(), family.apart.begin(),
                         family.apart.begin() + static_cast<std::ptrdiff_t>(family.count));
    }
  }
}

TraversalCounts EnodeFront::next(std::span<const Box> boxes_a, std::span<const Box> boxes_b,
                                 const TraversalVisitor& visitor) {
  const PlainArithmetic plain;
  const PosedTree a{a_, boxes_a};
  const PosedTree b{b_, boxes_b};
  detail::check_boxes(a, b);
  detail::Probe probe(a, b, visitor);
  next_front_.clear();
  test_front(probe);
  detail::enter_all(probe, options_, stack_, &next_front_);
  rise(probe);
  // Only where the visitor stopped: what was tested and not entered stays.
  next_front_.insert(next_front_.end(), stack_.rbegin(), stack_.rend());
  front_.swap(next_front_);
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
