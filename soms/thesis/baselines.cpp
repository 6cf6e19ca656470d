#include "soms/thesis/baselines.h"

#include "soms/thesis/detail/child_pairs.h"
#include "soms/thesis/detail/probe.h"

#include <iterator>

namespace soms::detail {

namespace {

void traverse_by_stack(Probe& probe, Traversal rule, bool prune, std::vector<NodePair>& stack) {
  stack.assign(1, NodePair{});
  while (!stack.empty() && !probe.stopped()) {
    const NodePair p = probe.pop(stack);
    const bool hit = probe.test(p);
    if (probe.stopped() || (!hit && prune)) {
      continue;
    }
    if (!probe.leaves(p)) {
      const ChildPairs children = child_pairs(probe, p, rule);
      stack.insert(stack.end(), std::make_reverse_iterator(children.end()),
                   std::make_reverse_iterator(children.begin()));
    } else if (hit) {
      probe.report(p);
    }
  }
}

// Depth is at most that of both trees together, which `traverse` has bounded.
void recurse(Probe& probe, Traversal rule, bool prune, NodePair p, std::uint32_t nesting) {
  probe.enter(p, nesting);
  const bool hit = probe.test(p);
  if (probe.stopped() || (!hit && prune)) {
    return;
  }
  if (probe.leaves(p)) {
    if (hit) {
      probe.report(p);
    }
    return;
  }
  const ChildPairs children = child_pairs(probe, p, rule);
  for (const NodePair child : children) {
    if (!probe.stopped()) {
      recurse(probe, rule, prune, child, nesting + 1);
    }
  }
}

TraversalCounts run(Traversal rule, const PosedTree& a, const PosedTree& b,
                    const TraversalOptions& options, const TraversalVisitor& visitor,
                    TraversalWorkspace& workspace) {
  Probe probe(a, b, visitor);
  if (options.recursive) {
    recurse(probe, rule, options.prune, NodePair{}, 1);
  } else {
    traverse_by_stack(probe, rule, options.prune, workspace.stack);
  }
  return probe.counts;
}

}  // namespace

TraversalCounts a_first(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  return run(Traversal::a_first, a, b, options, visitor, workspace);
}

TraversalCounts b_first(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  return run(Traversal::b_first, a, b, options, visitor, workspace);
}

TraversalCounts alternate(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                          const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  return run(Traversal::alternate, a, b, options, visitor, workspace);
}

TraversalCounts larger(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                       const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  return run(Traversal::larger, a, b, options, visitor, workspace);
}

TraversalCounts simultaneous(const PosedTree& a, const PosedTree& b,
                             const TraversalOptions& options, const TraversalVisitor& visitor,
                             TraversalWorkspace& workspace) {
  return run(Traversal::simultaneous, a, b, options, visitor, workspace);
}

TraversalCounts ericson(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                        const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  return run(options.ericson_rule, a, b, options, visitor, workspace);
}

}  // namespace soms::detail
