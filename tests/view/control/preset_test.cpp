#include "apps/view/control/preset.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(Preset, OfTheThesisIsItsTreeItsTraversalAndTheBoxes) {
  ViewState state;
  EXPECT_EQ(preset_of(state), Preset::product);
  state.prune = false;
  choose(state, Preset::thesis);
  ViewState named;
  begin_with(named, thesis_options(Rule::soms), {.traversal = Traversal::e_node});
  EXPECT_EQ(state.rule, named.rule);
  EXPECT_EQ(state.tree, named.tree);
  EXPECT_EQ(state.traversal, Traversal::e_node);
  EXPECT_EQ(state.descent, Descent::both);
  EXPECT_TRUE(state.prune);
  EXPECT_TRUE(state.shown.visited && state.shown.pruned && state.shown.found);
  EXPECT_EQ(preset_of(state), Preset::thesis);
}

TEST(Preset, IsActiveOnlyWhileNothingOfItDiffers) {
  ViewState thesis;
  choose(thesis, Preset::thesis);
  const auto changed = [&](auto&& change) {
    ViewState state = thesis;
    change(state);
    return preset_of(state);
  };
  EXPECT_EQ(changed([](ViewState& s) { s.tree.per_leaf = 2; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.tree.level = 14; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.tree.midpoint = Midpoint::aabb; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.tree.empty_side = EmptySide::chain; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.rule = Rule::sah; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.traversal = Traversal::ericson; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.descent = Descent::cross; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.prune = false; }), std::nullopt);
  EXPECT_EQ(changed([](ViewState& s) { s.shown.found = false; }), Preset::thesis);
}

TEST(Preset, OfTheProductTakesTheBoxesAway) {
  ViewState state;
  choose(state, Preset::thesis);
  choose(state, Preset::product);
  EXPECT_EQ(preset_of(state), Preset::product);
  EXPECT_EQ(state.traversal, Traversal::fast);
  EXPECT_FALSE(state.shown.visited || state.shown.pruned || state.shown.found);
}

TEST(Preset, BoxesNeedATraversalThatHasSome) {
  ViewState state;
  show_traversed(state);
  EXPECT_EQ(state.traversal, Traversal::e_node);
  EXPECT_TRUE(state.shown.found);
  state.traversal = Traversal::larger;
  show_traversed(state);
  EXPECT_EQ(state.traversal, Traversal::larger);
}

}  // namespace
}  // namespace soms::view
