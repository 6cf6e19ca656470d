#include "soms/query/traversal/baselines.h"

#include "soms/base/error.h"
#include "soms/query/traversal/detail/child_pairs.h"
#include "soms/query/traversal/detail/probe.h"
#include "soms/query/traversal/traversals.h"

#include <algorithm>
#include <string>

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

// Depth is at most that of both trees together, which `check_depth` has bounded.
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

std::uint32_t depth(const Tree& tree) {
  const auto deepest = std::max_element(
      tree.nodes.begin(), tree.nodes.end(),
      [](const Node& left, const Node& right) { return left.depth < right.depth; });
  return deepest->depth;
}

void check_depth(const PosedTree& a, const PosedTree& b) {
  const std::uint64_t nesting = std::uint64_t{depth(*a.tree)} + depth(*b.tree) + 1;
  if (nesting > kMaxRecursion) {
    throw Error(ErrorKind::usage,
                "recursive traversal: depths of " + std::to_string(depth(*a.tree)) + " and " +
                    std::to_string(depth(*b.tree)) + " need " + std::to_string(nesting) +
                    " nested calls, above " + std::to_string(kMaxRecursion),
                "leave `recursive` off: the explicit stack has no limit");
  }
}

TraversalCounts run(Traversal rule, const PosedTree& a, const PosedTree& b,
                    const TraversalOptions& options, const TraversalVisitor& visitor,
                    TraversalWorkspace& workspace) {
  Probe probe(a, b, visitor);
  if (options.recursive) {
    check_depth(a, b);
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
