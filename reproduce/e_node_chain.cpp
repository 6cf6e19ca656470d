#include "reproduce/e_node_chain.h"

#include "soms/base/arithmetic.h"
#include "soms/query/traversal/detail/child_pairs.h"
#include "soms/query/traversal/detail/probe.h"
#include "soms/query/traversal/traversals.h"

#include <iterator>

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

}  // namespace

TraversalCounts e_node_chain(const PosedTree& a, const PosedTree& b,
                             const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  const PlainArithmetic plain;
  detail::check_boxes(a, b);
  if (a.tree->nodes.empty() || b.tree->nodes.empty()) {
    return {};
  }
  Probe probe(a, b, visitor);
  const NodePair roots;
  workspace.stack.clear();
  if (probe.test(roots) && !probe.stopped()) {
    if (probe.leaves(roots)) {
      probe.report(roots);
    } else {
      workspace.stack.push_back(roots);
    }
  }
  while (!workspace.stack.empty() && !probe.stopped()) {
    ChildPairs enter = divide(probe, probe.pop(workspace.stack));
    while (enter.size() == 1 && !probe.stopped()) {
      enter = divide(probe, enter[0]);
    }
    workspace.stack.insert(workspace.stack.end(), std::make_reverse_iterator(enter.end()),
                           std::make_reverse_iterator(enter.begin()));
  }
  return probe.counts;
}

}  // namespace soms::reproduce
