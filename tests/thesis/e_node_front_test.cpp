#include "soms/thesis/e_node_front.h"

#include "soms/base/error.h"
#include "soms/thesis/posed_boxes.h"
#include "soms/thesis/traversals.h"

#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace soms {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;
using Pairs = std::vector<NodePair>;

Pair key(NodePair p) {
  return {p.a, p.b};
}

/// The design's pseudo code word for word, with the parents of pairs remembered as they were
/// entered instead of computed. Descents both and larger, order tree.
class FrontTwin {
 public:
  FrontTwin(const Tree& a, const Tree& b, Descent descent) : a_(a), b_(b), descent_(descent) {
    front_.push_back({});
  }

  Pairs next(const std::vector<Box>& boxes_a, const std::vector<Box>& boxes_b) {
    tests = entered = 0;
    const auto hit = [&](NodePair p) {
      ++tests;
      return overlaps(boxes_a[p.a], boxes_b[p.b]);
    };
    Pairs reported;
    Pairs front;
    Pairs live;
    std::vector<std::pair<Pair, Pairs>> dead;
    for (const NodePair p : front_) {
      if (!hit(p)) {
        add_dead(dead, p, front);
      } else if (leaves(p)) {
        reported.push_back(p);
        front.push_back(p);
      } else {
        live.push_back(p);
      }
    }
    std::reverse(live.begin(), live.end());
    while (!live.empty()) {
      const NodePair p = live.back();
      live.pop_back();
      ++entered;
      Pairs go;
      for (const NodePair c : children(p)) {
        up_[key(c)] = p;
        const bool overlap = hit(c);
        if (overlap && leaves(c)) {
          reported.push_back(c);
        }
        (overlap && !leaves(c) ? go : front).push_back(c);
      }
      live.insert(live.end(), go.rbegin(), go.rend());
    }
    for (const auto& [up, pairs] : dead) {
      const NodePair parent{up.first, up.second};
      if (pairs.size() == children(parent).size() && !hit(parent)) {
        front.push_back(parent);
      } else {
        front.insert(front.end(), pairs.begin(), pairs.end());
      }
    }
    front_ = front;
    return reported;
  }

  [[nodiscard]] const Pairs& front() const { return front_; }

  std::uint64_t tests = 0;
  std::uint64_t entered = 0;

 private:
  void add_dead(std::vector<std::pair<Pair, Pairs>>& dead, NodePair p, Pairs& front) const {
    const auto up = up_.find(key(p));
    if (up == up_.end()) {
      front.push_back(p);
      return;
    }
    const auto family = std::find_if(dead.begin(), dead.end(), [&](const auto& entry) {
      return entry.first == key(up->second);
    });
    if (family == dead.end()) {
      dead.push_back({key(up->second), {p}});
    } else {
      family->second.push_back(p);
    }
  }

  [[nodiscard]] bool leaves(NodePair p) const {
    return a_.nodes[p.a].is_leaf() && b_.nodes[p.b].is_leaf();
  }

  [[nodiscard]] Pairs children(NodePair p) const {
    const Node& a = a_.nodes[p.a];
    const Node& b = b_.nodes[p.b];
    const bool larger = descent_ == Descent::larger;
    const bool a_is_larger = volume(a.bounds) >= volume(b.bounds);
    const bool descend_a = !a.is_leaf() && (b.is_leaf() || !larger || a_is_larger);
    const bool descend_b = !b.is_leaf() && (a.is_leaf() || !larger || !a_is_larger);
    Pairs out;
    for (const std::uint32_t i : descend_a ? std::vector{a.left, a.right} : std::vector{p.a}) {
      for (const std::uint32_t j : descend_b ? std::vector{b.left, b.right} : std::vector{p.b}) {
        out.push_back({i, j});
      }
    }
    return out;
  }

  const Tree& a_;
  const Tree& b_;
  Descent descent_;
  Pairs front_;
  std::map<Pair, NodePair> up_;
};

/// Two bodies that move a little from frame to frame, now and then far.
class Dance {
 public:
  explicit Dance(Rng& rng)
      : rng_(rng),
        kind_(test::kKinds[rng.below(test::kKinds.size())]),
        mesh_a_(test::body(rng, kind_, 1 + rng.below(40))),
        mesh_b_(test::body(rng, kind_, 1 + rng.below(40))),
        tree_a(test::random_tree(rng, mesh_a_, 1 + rng.below(2))),
        tree_b(test::random_tree(rng, mesh_b_, 1 + rng.below(2))),
        a(mesh_a_, tree_a),
        b(mesh_b_, tree_b) {
    a.move(test::pose(rng, kind_));
  }

  void step() {
    constexpr double kReach[] = {0, 0.1, 0.1, 1, 5};
    b.move(test::pose(rng_, kind_, kReach[rng_.below(5)]));
  }

 private:
  Rng& rng_;
  test::Kind kind_;
  Mesh mesh_a_, mesh_b_;

 public:
  Tree tree_a, tree_b;
  PosedBoxes a, b;
};

Pairs reported(EnodeFront& front, const Dance& dance, TraversalCounts* counts = nullptr) {
  Pairs out;
  const auto c = front.next(dance.a.boxes(), dance.b.boxes(), {.leaf_pair = [&](NodePair p) {
                              out.push_back(p);
                              return true;
                            }});
  if (counts != nullptr) {
    *counts = c;
  }
  return out;
}

template <class Body>
void for_each_dance(const char* tag, int n, const Body& body) {
  test::for_each_case(tag, n, [&](Rng& rng) {
    Dance dance(rng);
    for (const Descent descent : {Descent::both, Descent::larger}) {
      body(dance, descent, rng);
    }
  });
}

TEST(EnodeFront, MissesNothingInAnyFrame) {
  for_each_dance("front/answers", 60, [](Dance& dance, Descent descent, Rng& rng) {
    EnodeFront front(dance.tree_a, dance.tree_b, descent,
                     rng.below(2) == 0 ? EntryOrder::tree : EntryOrder::volume);
    for (int frame = 0; frame < 12; ++frame) {
      dance.step();
      EXPECT_EQ(test::sorted(reported(front, dance)),
                test::overlapping_leaves(dance.a.view(), dance.b.view()));
    }
  });
}

TEST(EnodeFront, DoesWhatTheDesignSaysWithParentsRemembered) {
  for_each_dance("front/twin", 60, [](Dance& dance, Descent descent, Rng& /*rng*/) {
    EnodeFront front(dance.tree_a, dance.tree_b, descent);
    FrontTwin twin(dance.tree_a, dance.tree_b, descent);
    for (int frame = 0; frame < 12; ++frame) {
      dance.step();
      const Pairs expected = twin.next(dance.a.boxes(), dance.b.boxes());
      TraversalCounts counts;
      EXPECT_EQ(reported(front, dance, &counts), expected);
      EXPECT_EQ(counts.box_tests, twin.tests);
      EXPECT_EQ(counts.entered, twin.entered);
      EXPECT_EQ(Pairs(front.front().begin(), front.front().end()), twin.front());
    }
  });
}

/// How many pairs of `front` are above or at a pair of leaves, by the ancestors of each.
std::size_t covers(const Tree& a, const Tree& b, std::span<const NodePair> front, NodePair leaf) {
  const auto holds = [](const Tree& tree, std::uint32_t node, std::uint32_t below) {
    std::uint32_t at = 0;  // nodes are in depth-first order: the right child starts its own run
    while (at < below && at != node) {
      at = below >= tree.nodes[at].right ? tree.nodes[at].right : tree.nodes[at].left;
    }
    return at == node;
  };
  return static_cast<std::size_t>(std::count_if(front.begin(), front.end(), [&](NodePair p) {
    return holds(a, p.a, leaf.a) && holds(b, p.b, leaf.b);
  }));
}

void expect_cover(const Dance& dance, const EnodeFront& front) {
  for (std::uint32_t i = 0; i < dance.tree_a.nodes.size(); ++i) {
    for (std::uint32_t j = 0; j < dance.tree_b.nodes.size(); ++j) {
      if (dance.tree_a.nodes[i].is_leaf() && dance.tree_b.nodes[j].is_leaf()) {
        EXPECT_EQ(covers(dance.tree_a, dance.tree_b, front.front(), {i, j}), 1U) << i << ' ' << j;
      }
    }
  }
}

TEST(EnodeFront, CoversEachPairOfLeavesOnce) {
  for_each_dance("front/cover", 10, [](Dance& dance, Descent descent, Rng& /*rng*/) {
    EnodeFront front(dance.tree_a, dance.tree_b, descent);
    expect_cover(dance, front);
    for (int frame = 0; frame < 5; ++frame) {
      dance.step();
      reported(front, dance);
      expect_cover(dance, front);
    }
  });
}

TEST(EnodeFront, IsRightAfterFramesThatWereStoppedOrFailed) {
  for_each_dance("front/stopped", 40, [](Dance& dance, Descent descent, Rng& rng) {
    EnodeFront front(dance.tree_a, dance.tree_b, descent);
    for (int frame = 0; frame < 12; ++frame) {
      dance.step();
      std::uint64_t left = rng.below(4);
      if (rng.below(2) == 0) {
        front.next(dance.a.boxes(), dance.b.boxes(),
                   {.leaf_pair = [&](NodePair) { return left-- > 0; }});
      } else {
        try {
          front.next(dance.a.boxes(), dance.b.boxes(), {.leaf_pair = [&](NodePair) -> bool {
                       throw std::runtime_error("the visitor fails");
                     }});
        } catch (const std::runtime_error&) {
        }
      }
      expect_cover(dance, front);
      dance.step();
      EXPECT_EQ(test::sorted(reported(front, dance)),
                test::overlapping_leaves(dance.a.view(), dance.b.view()));
    }
  });
}

TEST(EnodeFront, StaysRightWhenItsClockRunsOut) {
  Rng rng(3);
  const Mesh mesh = test::body(rng, test::Kind::random, 300);
  const Tree tree = test::random_tree(rng, mesh, 1);
  PosedBoxes boxes(mesh, tree);
  boxes.move({});
  const Pairs expected = test::overlapping_leaves(boxes.view(), boxes.view());
  for (const Descent descent : {Descent::both, Descent::larger}) {
    EnodeFront front(tree, tree, descent);
    for (int patience = 0; patience < 6; ++patience) {
      int left = patience;
      front.next(boxes.boxes(), boxes.boxes(), {.keep_going = [&] { return left-- > 0; }});
      Pairs found;
      front.next(boxes.boxes(), boxes.boxes(), {.leaf_pair = [&](NodePair p) {
                   found.push_back(p);
                   return true;
                 }});
      EXPECT_EQ(test::sorted(found), expected);
      front.restart();
    }
  }
}

TEST(EnodeFront, StartsAnewWhenReported) {
  Rng rng(5);
  Dance dance(rng);
  dance.step();
  EnodeFront front(dance.tree_a, dance.tree_b, Descent::larger);
  TraversalCounts first;
  TraversalCounts again;
  reported(front, dance, &first);
  front.restart();
  EXPECT_EQ(front.front().size(), 1U);
  reported(front, dance, &again);
  EXPECT_EQ(first, again);
}

TEST(EnodeFront, TestsOnlyItsFrontWhereNothingMoves) {
  Rng rng(7);
  Dance dance(rng);
  dance.step();
  for (const Descent descent : {Descent::both, Descent::larger}) {
    EnodeFront front(dance.tree_a, dance.tree_b, descent);
    reported(front, dance);
    reported(front, dance);
    TraversalCounts counts;
    const std::size_t size = front.front().size();
    reported(front, dance, &counts);
    EXPECT_EQ(counts.entered, 0U);
    EXPECT_GE(counts.box_tests, size);
    EXPECT_EQ(front.front().size(), size);
  }
}

TEST(EnodeFront, RefusesDescentsThatDependOnPosesAndOtherBoxes) {
  Rng rng(9);
  const Dance dance(rng);
  EXPECT_THROW(EnodeFront(dance.tree_a, dance.tree_b, Descent::cross), Error);
  EXPECT_THROW(EnodeFront(dance.tree_a, dance.tree_b, Descent::fewest), Error);
  EnodeFront front(dance.tree_a, dance.tree_b);
  const std::vector<Box> wrong(dance.tree_a.nodes.size() + 1);
  EXPECT_THROW(front.next(wrong, dance.b.boxes()), Error);
}

TEST(EnodeFront, IsEmptyWithAnEmptyTree) {
  Rng rng(11);
  Dance dance(rng);
  dance.step();
  const Tree none;
  EnodeFront front(none, dance.tree_b);
  EXPECT_TRUE(front.front().empty());
  EXPECT_EQ(front.next({}, dance.b.boxes()), TraversalCounts{});
}

}  // namespace
}  // namespace soms
