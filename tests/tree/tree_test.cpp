#include "soms/tree/tree.h"

#include "soms/tree/build.h"

#include "tests/tree/inputs.h"

#include <cmath>

namespace soms {
namespace {

TEST(TreeId, DepthIsFloorOfLogarithmOfNextNumber) {
  EXPECT_EQ(depth_of(0), 0);
  EXPECT_EQ(depth_of(1), 1);
  EXPECT_EQ(depth_of(2), 1);
  EXPECT_EQ(depth_of(3), 2);
  EXPECT_EQ(depth_of(6), 2);
  EXPECT_EQ(depth_of(7), 3);
  EXPECT_EQ(depth_of((TreeId{1} << 40) - 2), 39);
  EXPECT_EQ(depth_of((TreeId{1} << 40) - 1), 40);
  EXPECT_EQ(depth_of(kNoTreeId - 1), kMaxTreeIdDepth);
  EXPECT_EQ(depth_of(kNoTreeId), -1);
}

TEST(TreeId, ChildrenAreOddLeftAndEvenRightAndKnowTheirParent) {
  for (const TreeId id : {TreeId{0}, TreeId{1}, TreeId{2}, TreeId{1000}, (TreeId{1} << 62) - 2}) {
    EXPECT_EQ(left_child_of(id) % 2, 1U);
    EXPECT_EQ(right_child_of(id), left_child_of(id) + 1);
    EXPECT_EQ(parent_of(left_child_of(id)), id);
    EXPECT_EQ(parent_of(right_child_of(id)), id);
    EXPECT_EQ(depth_of(left_child_of(id)), depth_of(id) + 1);
  }
  EXPECT_EQ(parent_of(0), kNoTreeId);
}

TEST(TreeId, IsAbsentBelowDepth63) {
  const TreeId last = (TreeId{1} << 63) - 2;  // the last of depth 62
  EXPECT_EQ(right_child_of(last), kNoTreeId - 1);
  EXPECT_EQ(left_child_of(kNoTreeId - 1), kNoTreeId);
  EXPECT_EQ(right_child_of((TreeId{1} << 63) - 1), kNoTreeId);
  EXPECT_EQ(left_child_of(kNoTreeId), kNoTreeId);
  EXPECT_EQ(right_child_of(kNoTreeId), kNoTreeId);
  EXPECT_EQ(parent_of(kNoTreeId), kNoTreeId);
}

TEST(Tree, FindsEveryNodeByItsIdAndNoOther) {
  const Tree tree =
      build(test::make_input(test::Input::random, 200), thesis_options(Rule::spatial_median));
  for (const Node& node : tree.nodes) {
    EXPECT_EQ(find_node(tree, node.id), &node);
    if (node.is_leaf()) {
      EXPECT_EQ(find_node(tree, left_child_of(node.id)), nullptr);
    }
  }
  EXPECT_EQ(find_node(tree, kNoTreeId), nullptr);
  EXPECT_EQ(find_node(tree, kNoTreeId - 1), nullptr);
  EXPECT_EQ(find_node(Tree{}, 0), nullptr);
}

TEST(TreeHash, TellsTreesApartAndIgnoresTheSignOfZero) {
  const Mesh mesh = test::make_input(test::Input::coplanar, 30);
  Tree tree = build(mesh);
  const std::uint64_t hash = tree_hash(tree);
  EXPECT_EQ(tree_hash(build(mesh)), hash);
  tree.nodes[0].bounds.lower.z = -0.0;
  EXPECT_EQ(tree_hash(tree), hash);
  tree.nodes[0].undividable = !tree.nodes[0].undividable;
  EXPECT_NE(tree_hash(tree), hash);
  tree.nodes[0].undividable = !tree.nodes[0].undividable;
  std::swap(tree.primitives[0], tree.primitives[1]);
  EXPECT_NE(tree_hash(tree), hash);
}

}  // namespace
}  // namespace soms
