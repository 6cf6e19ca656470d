#include "apps/view/scene/traversal_trace.h"

#include "soms/generate/shapes.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/build.h"

#include <gtest/gtest.h>

#include <set>

namespace soms::view {
namespace {

/// Two knots, one of them moved, with trees of small leaves.
struct Knots {
  Mesh mesh = generate_knot(300);
  Tree tree = build(mesh, thesis_options(Rule::soms, 24));
  PosedBoxes still{mesh, tree};
  PosedBoxes moving{mesh, tree};

  explicit Knots(const Pose& pose) {
    still.move(Pose::identity());
    moving.move(pose);
  }

  [[nodiscard]] TraversalTrace trace(const TraversalOptions& options) const {
    return watch(still.view(), moving.view(), options);
  }
};

std::vector<TraversalOptions> all_traversal_options() {
  std::vector<TraversalOptions> options;
  for (const TraversalEntry& row : traversals()) {
    if (row.traversal != Traversal::fast) {
      options.push_back(without_idle({.traversal = row.traversal, .descent = Descent::larger}));
    }
  }
  return options;
}

void expect_consistent(const TraversalTrace& trace, const Knots& knots) {
  EXPECT_EQ(trace.overlapping + trace.apart, trace.counts.box_tests);
  for (const std::vector<Fate>* fates : {&trace.a, &trace.b}) {
    ASSERT_EQ(fates->size(), knots.tree.nodes.size());
    for (std::size_t n = 0; n < fates->size(); ++n) {
      // Only leaves are found, and a parent is looked at before its children.
      const Node& node = knots.tree.nodes[n];
      EXPECT_TRUE((*fates)[n] != Fate::found || node.is_leaf());
      if (!node.is_leaf() && (*fates)[n] < Fate::visited) {
        EXPECT_EQ((*fates)[node.left], Fate::untouched);
        EXPECT_EQ((*fates)[node.right], Fate::untouched);
      }
    }
    const FateCounts counts = count_fates(*fates);
    EXPECT_EQ(counts.untouched + counts.pruned + counts.visited + counts.found, fates->size());
  }
  // By brute force: a leaf is found exactly if its box overlaps that of a leaf of the other tree.
  for (std::size_t n = 0; n < knots.tree.nodes.size(); ++n) {
    if (!knots.tree.nodes[n].is_leaf()) {
      continue;
    }
    bool expected = false;
    for (std::size_t m = 0; m < knots.tree.nodes.size(); ++m) {
      expected = expected || (knots.tree.nodes[m].is_leaf() &&
                              overlaps(knots.still.boxes()[n], knots.moving.boxes()[m]));
    }
    EXPECT_EQ(trace.a[n] == Fate::found, expected);
  }
}

TEST(TraversalTrace, AgreesWithTheCountersOfEveryTraversal) {
  const Knots knots(Pose::about_z(0.3, {0.9, 0.2, 0.1}));
  for (const TraversalOptions& options : all_traversal_options()) {
    SCOPED_TRACE(entry(options.traversal).name);
    const TraversalTrace trace = knots.trace(options);
    EXPECT_EQ(trace.counts, traverse(knots.still.view(), knots.moving.view(), options));
    EXPECT_FALSE(trace.cut);
    EXPECT_EQ(trace.pruned, trace.apart);
    EXPECT_GT(trace.pruned, 0U);
    EXPECT_GT(trace.counts.leaf_pairs, 0U);
    expect_consistent(trace, knots);
  }
}

TEST(TraversalTrace, FindsNothingWhereRootsAreApart) {
  const Knots knots(Pose::translation(9, 0, 0));
  const TraversalTrace trace = knots.trace({.traversal = Traversal::larger});
  EXPECT_EQ(trace.a[0], Fate::pruned);
  EXPECT_EQ(trace.b[0], Fate::pruned);
  EXPECT_EQ(trace.apart, 1U);
  EXPECT_EQ(count_fates(trace.a).untouched, knots.tree.nodes.size() - 1);
}

TEST(TraversalTrace, VisitsFarMoreWithoutPruningAndFindsTheSame) {
  const Knots knots(Pose::translation(1.2, 0, 0));
  TraversalOptions options{.traversal = Traversal::simultaneous};
  const TraversalTrace pruned = knots.trace(options);
  options.prune = false;
  const TraversalTrace all = knots.trace(options);
  EXPECT_EQ(all.counts.leaf_pairs, pruned.counts.leaf_pairs);
  EXPECT_GT(all.counts.box_tests, 20 * pruned.counts.box_tests);
  EXPECT_EQ(count_fates(all.a).untouched, 0U);
  EXPECT_EQ(count_fates(all.a).found, count_fates(pruned.a).found);
  EXPECT_EQ(all.overlapping + all.apart, all.counts.box_tests);
  EXPECT_LT(all.pruned, all.apart);  // only leaves end a branch
}

TEST(TraversalTrace, IsCutAloudAtItsLimit) {
  const Knots knots(Pose::identity());
  TraversalOptions options{.traversal = Traversal::a_first};
  options.prune = false;
  const TraversalTrace trace = watch(knots.still.view(), knots.moving.view(), options, 4096);
  EXPECT_TRUE(trace.cut);
  EXPECT_LE(trace.counts.box_tests, 4096U);
  EXPECT_EQ(trace.overlapping + trace.apart, trace.counts.box_tests);
}

}  // namespace
}  // namespace soms::view
