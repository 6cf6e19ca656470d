#include "soms/thesis/e_node.h"

#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"

#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

namespace soms {
namespace {

using Pairs = std::vector<NodePair>;

/// The design's pseudo code of E-Node by recursion, with sets of tests written out.
class Twin {
 public:
  Twin(const PosedTree& a, const PosedTree& b, Descent descent, EntryOrder order)
      : a_(a), b_(b), descent_(descent), order_(order) {
    if (test({})) {
      if (leaves({})) {
        reported.push_back({});
      } else {
        enter({});
      }
    }
  }

  Pairs tested;
  Pairs entered;
  Pairs reported;

 private:
  bool test(NodePair p) {
    tested.push_back(p);
    return overlaps(a_.boxes[p.a], b_.boxes[p.b]);
  }

  [[nodiscard]] const Node& a(NodePair p) const { return a_.tree->nodes[p.a]; }

  [[nodiscard]] const Node& b(NodePair p) const { return b_.tree->nodes[p.b]; }

  [[nodiscard]] bool leaves(NodePair p) const { return a(p).is_leaf() && b(p).is_leaf(); }

  Pairs hits(const Pairs& candidates) {
    Pairs out;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(out),
                 [&](NodePair p) { return test(p); });
    return out;
  }

  [[nodiscard]] Pairs pairs(bool descend_a, bool descend_b, NodePair p) const {
    using Nodes = std::vector<std::uint32_t>;
    Pairs out;
    for (const std::uint32_t i : descend_a ? Nodes{a(p).left, a(p).right} : Nodes{p.a}) {
      for (const std::uint32_t j : descend_b ? Nodes{b(p).left, b(p).right} : Nodes{p.b}) {
        out.push_back({i, j});
      }
    }
    return out;
  }

  Pairs next(NodePair p) {
    const bool inner_a = !a(p).is_leaf();
    const bool inner_b = !b(p).is_leaf();
    const bool a_is_larger = volume(a(p).bounds) >= volume(b(p).bounds);
    if (!inner_a || !inner_b || descent_ == Descent::both) {
      return hits(pairs(inner_a, inner_b, p));
    }
    if (descent_ == Descent::larger) {
      return hits(pairs(a_is_larger, !a_is_larger, p));
    }
    const Pairs of_a = hits(pairs(true, false, p));
    const Pairs of_b = of_a.empty() ? Pairs{} : hits(pairs(false, true, p));
    if (descent_ == Descent::fewest) {
      const bool choose_a =
          of_a.size() < of_b.size() || (of_a.size() == of_b.size() && a_is_larger);
      return of_a.empty() || choose_a ? of_a : of_b;
    }
    Pairs crossed;
    for (const NodePair i : of_a) {
      for (const NodePair j : of_b) {
        crossed.push_back({i.a, j.b});
      }
    }
    return hits(crossed);
  }

  [[nodiscard]] double shared(NodePair p) const {
    const Box& x = a_.boxes[p.a];
    const Box& y = b_.boxes[p.b];
    double out = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      out *= std::min(x.upper[k], y.upper[k]) - std::max(x.lower[k], y.lower[k]);
    }
    return out;
  }

  void enter(NodePair p) {
    entered.push_back(p);
    Pairs found = next(p);
    if (order_ == EntryOrder::volume) {
      std::sort(found.begin(), found.end(), [&](NodePair l, NodePair r) {
        return std::tuple(-shared(l), l.a, l.b) < std::tuple(-shared(r), r.a, r.b);
      });
    }
    for (const NodePair child : found) {
      if (leaves(child)) {
        reported.push_back(child);
      }
    }
    for (const NodePair child : found) {
      if (!leaves(child)) {
        enter(child);
      }
    }
  }

  const PosedTree& a_;
  const PosedTree& b_;
  Descent descent_;
  EntryOrder order_;
};

TEST(Enode, DoesWhatTheDesignSaysStepByStep) {
  test::for_each_case("e_node/twin", 300, [](Rng& rng) {
    const test::Kind kind = test::kKinds[rng.below(test::kKinds.size())];
    const Mesh mesh_a = test::body(rng, kind, 1 + rng.below(40));
    const Mesh mesh_b = test::body(rng, kind, 1 + rng.below(40));
    const Tree tree_a = test::random_tree(rng, mesh_a, 1 + rng.below(3));
    const Tree tree_b = test::random_tree(rng, mesh_b, 1 + rng.below(3));
    PosedBoxes a(mesh_a, tree_a);
    PosedBoxes b(mesh_b, tree_b);
    a.move(test::pose(rng, kind));
    b.move(test::pose(rng, kind));
    const PosedTree view_a = a.view();
    const PosedTree view_b = b.view();
    for (const DescentEntry& descent : descents()) {
      for (const EntryOrder order : {EntryOrder::tree, EntryOrder::volume}) {
        SCOPED_TRACE(std::string(descent.name) + (order == EntryOrder::tree ? "" : " by volume"));
        const Twin twin(view_a, view_b, descent.descent, order);
        Pairs tested;
        Pairs entered;
        Pairs reported;
        TraversalVisitor visitor;
        visitor.tested = [&](NodePair p, bool) { tested.push_back(p); };
        visitor.entered = [&](NodePair p) { entered.push_back(p); };
        visitor.leaf_pair = [&](NodePair p) {
          reported.push_back(p);
          return true;
        };
        traverse(view_a, view_b,
                 {.traversal = Traversal::e_node, .descent = descent.descent, .order = order},
                 visitor);
        EXPECT_EQ(tested, twin.tested);
        EXPECT_EQ(entered, twin.entered);
        EXPECT_EQ(reported, twin.reported);
      }
    }
  });
}

}  // namespace
}  // namespace soms
