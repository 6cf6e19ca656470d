#include "thesis/races/e_node_chain.h"

#include "soms/base/arithmetic.h"
#include "soms/thesis/detail/child_pairs.h"
#include "soms/thesis/detail/probe.h"
#include "soms/thesis/traversals.h"

#include <cstdint>
#include <iterator>
#include <vector>

namespace soms::reproduce {

namespace {

using detail::ChildPairs;
using detail::Probe;

/// Tests the child pairs of a pair, then reports those of two leaves; returns those to be divided.
ChildPairs divide(Probe& probe, NodePair p) {
  ChildPairs enter;
  ChildPairs report;
  for (const NodePair child : detail::descend_both(probe, p)) {
    if (probe.test(child)) {
      (probe.leaves(child) ? report : enter).add(child);
    }
  }
  for (const NodePair leaves : report) {
    if (!probe.stopped()) {
      probe.report(leaves);
    }
  }
  return enter;
}

/// Goes down from an entered pair while one child pair alone is to be divided; returns the first
/// that are several, or none. Apart from `recurse`, whose frame stays small.
[[gnu::noinline]] ChildPairs descend_on(Probe& probe, NodePair p) {
  ChildPairs enter = divide(probe, p);
  while (enter.size() == 1 && !probe.stopped()) {
    enter = divide(probe, enter[0]);
  }
  return enter;
}

void recurse(Probe& probe, NodePair p, std::uint64_t nesting) {
  probe.enter(p, nesting);
  for (const NodePair child : descend_on(probe, p)) {
    if (!probe.stopped()) {
      recurse(probe, child, nesting + 1);
    }
  }
}

void enter_all(Probe& probe, NodePair roots, std::vector<NodePair>& stack) {
  stack.assign(1, roots);
  while (!stack.empty() && !probe.stopped()) {
    const ChildPairs enter = descend_on(probe, probe.pop(stack));
    stack.insert(stack.end(), std::make_reverse_iterator(enter.end()),
                 std::make_reverse_iterator(enter.begin()));
  }
}

}  // namespace

TraversalCounts e_node_chain(const PosedTree& a, const PosedTree& b, bool recursive,
                             const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  const PlainArithmetic plain;
  detail::check_boxes(a, b);
  if (a.tree->nodes.empty() || b.tree->nodes.empty()) {
    return {};
  }
  Probe probe(a, b, visitor);
  const NodePair roots;
  if (probe.test(roots) && !probe.stopped()) {
    if (probe.leaves(roots)) {
      probe.report(roots);
    } else if (recursive) {
      recurse(probe, roots, 1);
    } else {
      enter_all(probe, roots, workspace.stack);
    }
  }
  return probe.counts;
}

}  // namespace soms::reproduce
