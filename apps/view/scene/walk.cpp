#include "apps/view/scene/walk.h"

#include "soms/query/traversal/traversals.h"

#include <algorithm>
#include <chrono>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

/// Ends a traversal after a number of box tests.
std::function<bool()> limit(std::uint64_t most_tests, const Parallel& parallel, bool& cut) {
  return [asked = std::uint64_t{0}, most_tests, &parallel, &cut]() mutable {
    check_stop(parallel);
    asked += kBoxTestsBetweenAsks;
    cut = asked >= most_tests;
    return !cut;
  };
}

}  // namespace

Walk watch(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
           std::uint64_t most_tests, const Parallel& parallel) {
  Walk walk;
  walk.a.assign(a.tree->nodes.size(), Fate::untouched);
  walk.b.assign(b.tree->nodes.size(), Fate::untouched);
  const auto note = [&walk](NodePair p, Fate fate) {
    walk.a[p.a] = std::max(walk.a[p.a], fate);
    walk.b[p.b] = std::max(walk.b[p.b], fate);
  };
  TraversalVisitor plain;
  plain.keep_going = limit(most_tests, parallel, walk.cut);
  TraversalWorkspace workspace;
  const auto begin = Clock::now();
  walk.counts = traverse(a, b, options, plain, workspace);
  walk.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();

  TraversalVisitor watched;
  watched.keep_going = limit(most_tests, parallel, walk.cut);
  watched.tested = [&](NodePair p, bool overlap) {
    ++(overlap ? walk.overlapping : walk.apart);
    const bool leaves = a.tree->nodes[p.a].is_leaf() && b.tree->nodes[p.b].is_leaf();
    // Without pruning a pair is opened though its boxes are apart.
    const bool opened = overlap || (!options.prune && !leaves);
    walk.pruned += opened ? 0 : 1;
    note(p, opened ? Fate::visited : Fate::pruned);
  };
  watched.leaf_pair = [&](NodePair p) {
    note(p, Fate::found);
    return true;
  };
  (void)traverse(a, b, options, watched, workspace);
  return walk;
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
