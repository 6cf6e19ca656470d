#include "apps/view/scene/traversal_trace.h"

#include "soms/thesis/traversals.h"

#include <algorithm>
#include <chrono>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

/// Ends a traversal after a number of box tests.
std::function<bool()> limit(std::uint64_t most_tests, const Limits& limits, bool& cut) {
  return [queried = std::uint64_t{0}, most_tests, &limits, &cut]() mutable {
    check_stop(limits);
    queried += kBoxTestsBetweenAsks;
    cut = queried >= most_tests;
    return !cut;
  };
}

}  // namespace

TraversalTrace watch(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                     std::uint64_t most_tests, const Limits& limits) {
  TraversalTrace trace;
  trace.a.assign(a.tree->nodes.size(), Fate::untouched);
  trace.b.assign(b.tree->nodes.size(), Fate::untouched);
  const auto note = [&trace](NodePair p, Fate fate) {
    trace.a[p.a] = std::max(trace.a[p.a], fate);
    trace.b[p.b] = std::max(trace.b[p.b], fate);
  };
  TraversalVisitor plain;
  plain.keep_going = limit(most_tests, limits, trace.cut);
  TraversalWorkspace workspace;
  const auto begin = Clock::now();
  trace.counts = traverse(a, b, options, plain, workspace);
  trace.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();

  TraversalVisitor watched;
  watched.keep_going = limit(most_tests, limits, trace.cut);
  watched.tested = [&](NodePair p, bool overlap) {
    ++(overlap ? trace.overlapping : trace.apart);
    const bool leaves = a.tree->nodes[p.a].is_leaf() && b.tree->nodes[p.b].is_leaf();
    // Without pruning a pair is descended though its boxes are apart.
    const bool entered_anyway = overlap || (!options.prune && !leaves);
    trace.pruned += entered_anyway ? 0 : 1;
    note(p, entered_anyway ? Fate::visited : Fate::pruned);
  };
  watched.leaf_pair = [&](NodePair p) {
    note(p, Fate::found);
    return true;
  };
  (void)traverse(a, b, options, watched, workspace);
  return trace;
}

FateCounts count_fates(const std::vector<Fate>& fates) {
  FateCounts counts;
  for (const Fate fate : fates) {
    switch (fate) {
      case Fate::untouched:
        ++counts.untouched;
        break;
      case Fate::pruned:
        ++counts.pruned;
        break;
      case Fate::visited:
        ++counts.visited;
        break;
      case Fate::found:
        ++counts.found;
        break;
    }
  }
  return counts;
}

}  // namespace soms::view
