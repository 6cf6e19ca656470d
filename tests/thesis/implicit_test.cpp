#include "soms/thesis/implicit.h"

#include "soms/base/error.h"
#include "soms/tree/build.h"

#include "tests/tree/inputs.h"
#include "tests/tree/models.h"

#include <algorithm>

namespace soms {
namespace {

void expect_same(const Tree& tree, const ImplicitTree& implicit) {
  std::size_t used = 0;
  for (const auto& slot : implicit.slots) {
    used += slot.used;
  }
  EXPECT_EQ(used, tree.nodes.size());
  for (const Node& node : tree.nodes) {
    const ImplicitTree::Slot* slot = implicit.find(node.id);
    ASSERT_NE(slot, nullptr);
    EXPECT_EQ(slot->bounds, node.bounds);
    EXPECT_EQ(slot->undividable, node.undividable);
    EXPECT_EQ(implicit.is_leaf(node.id), node.is_leaf());
    EXPECT_TRUE(std::ranges::equal(implicit.triangles_of(*slot), tree.triangles_of(node)));
  }
  EXPECT_EQ(to_tree(implicit), tree);
}

TEST(ImplicitTree, HoldsTheSameNodesAsTheCanonicalTree) {
  for (const Rule rule :
       {Rule::object_median, Rule::object_mean, Rule::spatial_median, Rule::soms}) {
    for (const EmptySide empty : {EmptySide::stop, EmptySide::chain}) {
      for (const test::Input input : test::kInputs) {
        SCOPED_TRACE(test::name(input));
        BuildOptions options = thesis_options(rule, 12);
        options.empty_side = empty;
        const Tree tree = build(test::make_input(input, 150), options);
        expect_same(tree, to_implicit(tree, 12));
      }
    }
  }
}

TEST(ImplicitTree, OfTheBunnyUses1847Of32767Slots) {
  SOMS_NEEDS_OUTSIDE_DATA("the slots of the bunny's tree");
  const Tree tree = build(*test::golden_mesh(test::kGoldenModels[0]), thesis_options(Rule::soms));
  const ImplicitTree implicit = to_implicit(tree, 15);
  EXPECT_EQ(implicit.slots.size(), 32767U);
  EXPECT_EQ(tree.nodes.size(), 1847U);
  expect_same(tree, implicit);
}

TEST(ImplicitTree, RefusesLevelsThatAreTooSmallOrTooLarge) {
  const Tree tree =
      build(test::make_input(test::Input::random, 100), thesis_options(Rule::soms, 9));
  EXPECT_NO_THROW(static_cast<void>(to_implicit(tree, 9)));
  EXPECT_THROW(static_cast<void>(to_implicit(tree, 6)), Error);
  EXPECT_THROW(static_cast<void>(to_implicit(tree, 25)), Error);
  EXPECT_THROW(static_cast<void>(to_implicit(Tree{}, 0)), Error);
}

TEST(ImplicitTree, OfAnEmptyTreeHasNoNode) {
  const ImplicitTree implicit = to_implicit(Tree{}, 3);
  EXPECT_EQ(implicit.slots.size(), 7U);
  EXPECT_EQ(implicit.find(0), nullptr);
  EXPECT_FALSE(implicit.is_leaf(0));
  EXPECT_EQ(to_tree(implicit), Tree{});
}

}  // namespace
}  // namespace soms
