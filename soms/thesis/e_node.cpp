#include "soms/thesis/e_node.h"

#include "soms/thesis/detail/e_node_step.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

namespace soms::detail {

namespace {

/// What became of the tested child pairs of one pair.
struct Outcome {
  ChildPairs enter;   ///< to be divided further
  ChildPairs report;  ///< overlapping pairs of leaves
};

// By insertion: at most four pairs, and no memory. Child pairs come in the order of their TreeIDs
// and equal volumes are not swapped, so ties stay in that order.
void sort_by_volume(const Probe& probe, ChildPairs& pairs) {
  std::array<double, 4> volumes{};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    volumes[i] = probe.shared_volume(pairs[i]);
    for (std::size_t k = i; k > 0 && volumes[k] > volumes[k - 1]; --k) {
      std::swap(volumes[k], volumes[k - 1]);
      std::swap(pairs.begin()[k], pairs.begin()[k - 1]);
    }
  }
}

/// Tests the child pairs of one pair.
class Step {
 public:
  Step(Probe& probe, const TraversalOptions& options, std::vector<NodePair>* front)
      : probe_(probe), options_(options), front_(front) {}

  // Called in two places; out of line it slows the loop over the stack.
  [[nodiscard, gnu::always_inline]] inline Outcome operator()(NodePair p) {
    const bool inner = !probe_.node_a(p.a).is_leaf() && !probe_.node_b(p.b).is_leaf();
    if (options_.descent == Descent::fewest && inner) {
      return {fewest(p), {}};
    }
    switch (options_.descent) {
      case Descent::cross:
        return inner ? tested(cross(p)) : tested(descend_both(probe_, p));
      case Descent::both:
        return tested(descend_both(probe_, p));
      default:
        return tested(child_pairs(probe_, p, Traversal::larger));
    }
  }

  [[nodiscard]] const TraversalOptions& options() const { return options_; }

 private:
  [[nodiscard]] ChildPairs survivors(const ChildPairs& candidates) {
    ChildPairs out;
    for (const NodePair p : candidates) {
      if (probe_.test(p) || !options_.prune) {
        out.add(p);
      }
    }
    return out;
  }

  /// Pairs of the children that overlap the other node.
  [[nodiscard]] ChildPairs cross(NodePair p) {
    ChildPairs out;
    const ChildPairs of_a = survivors(descend_a(probe_, p));
    if (of_a.size() > 0) {
      const ChildPairs of_b = survivors(descend_b(probe_, p));
      for (const NodePair i : of_a) {
        for (const NodePair j : of_b) {
          out.add({i.a, j.b});
        }
      }
    }
    return out;
  }

  /// The shorter list of overlapping pairs, of descending the first node and of descending the
  /// second.
  [[nodiscard]] ChildPairs fewest(NodePair p) {
    const ChildPairs of_a = survivors(descend_a(probe_, p));
    if (of_a.size() == 0) {
      return of_a;
    }
    const ChildPairs of_b = survivors(descend_b(probe_, p));
    if (of_a.size() != of_b.size()) {
      return of_a.size() < of_b.size() ? of_a : of_b;
    }
    return first_is_larger(probe_.node_a(p.a), probe_.node_b(p.b)) ? of_a : of_b;
  }

  [[nodiscard]] Outcome tested(const ChildPairs& candidates) {
    Outcome out;
    for (const NodePair p : candidates) {
      const bool hit = probe_.test(p);
      if (!hit && options_.prune) {
        stay(p);
      } else if (!probe_.leaves(p)) {
        out.enter.add(p);
      } else if (hit) {
        out.report.add(p);
        stay(p);
      }
    }
    return out;
  }

  /// The descent ends at `p`.
  void stay(NodePair p) {
    if (front_ != nullptr) {
      front_->push_back(p);
    }
  }

  Probe& probe_;
  const TraversalOptions& options_;
  std::vector<NodePair>* front_;
};

void put_in_order(const Probe& probe, const TraversalOptions& options, Outcome& children) {
  if (options.order == EntryOrder::volume) {
    sort_by_volume(probe, children.enter);
    sort_by_volume(probe, children.report);
  }
}

void report_all(Probe& probe, const ChildPairs& pairs) {
  for (const NodePair pair : pairs) {
    if (!probe.stopped()) {
      probe.report(pair);
    }
  }
}

// Apart from `recurse`, whose frame stays small.
[[gnu::noinline]] Outcome divide(Step& step, NodePair p) {
  return step(p);
}

// Depth is at most that of both trees together, which `traverse` has bounded.
void recurse(Probe& probe, Step& step, NodePair p, std::uint64_t nesting) {
  probe.enter(p, nesting);
  Outcome children = divide(step, p);
  put_in_order(probe, step.options(), children);
  report_all(probe, children.report);
  for (const NodePair child : children.enter) {
    if (!probe.stopped()) {
      recurse(probe, step, child, nesting + 1);
    }
  }
}

}  // namespace

double Probe::shared_volume(NodePair p) const {
  const Box& a = boxes_a_[p.a];
  const Box& b = boxes_b_[p.b];
  Box shared;
  for (std::size_t k = 0; k < 3; ++k) {
    shared.lower[k] = std::max(a.lower[k], b.lower[k]);
    shared.upper[k] = std::min(a.upper[k], b.upper[k]);
  }
  return volume(shared);
}

void enter_all(Probe& probe, const TraversalOptions& options, std::vector<NodePair>& stack,
               std::vector<NodePair>* front) {
  Step step(probe, options, front);
  while (!stack.empty() && !probe.stopped()) {
    Outcome children = step(probe.pop(stack));
    put_in_order(probe, options, children);
    stack.insert(stack.end(), std::make_reverse_iterator(children.enter.end()),
                 std::make_reverse_iterator(children.enter.begin()));
    report_all(probe, children.report);
  }
}

TraversalCounts e_node(const PosedTree& a, const PosedTree& b, const TraversalOptions& options,
                       const TraversalVisitor& visitor, TraversalWorkspace& workspace) {
  Probe probe(a, b, visitor);
  const NodePair roots;
  const bool hit = probe.test(roots);
  if (probe.leaves(roots)) {
    if (hit && !probe.stopped()) {
      probe.report(roots);
    }
  } else if (hit || !options.prune) {
    if (options.recursive && !probe.stopped()) {
      Step step(probe, options, nullptr);
      recurse(probe, step, roots, 1);
    } else {
      workspace.stack.assign(1, roots);
      enter_all(probe, options, workspace.stack, nullptr);
    }
  }
  return probe.counts;
}

}  // namespace soms::detail
