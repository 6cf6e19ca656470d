#include "soms/thesis/traversals.h"
#include "soms/tree/option_names.h"

#include "apps/view/control/preset.h"
#include "apps/view/scene/orientation_menu.h"
#include "tests/view/control/panels_fixture.h"

#include <gtest/gtest.h>

#include <string>

namespace soms::view {
namespace {

using PanelTrees = PanelsTest;

TEST_F(PanelTrees, EachDescentCanBeChosenWhereThereIsOne) {
  EXPECT_EQ(find("Descent"), nullptr);
  choose("Traversal", "e-node");
  for (const DescentEntry& descent : descents()) {
    if (descent.descent != state().descent) {
      choose("Descent", std::string(descent.kebab));
    }
    EXPECT_EQ(state().descent, descent.descent);
    EXPECT_EQ(subject_.last_choice.descent, descent.descent);
  }
  choose("Traversal", "e-node-front");
  click("Descent", 0.2);
  EXPECT_NE(find("larger"), nullptr);
  EXPECT_EQ(find("fewest"), nullptr);  // the front does not take it
}

TEST_F(PanelTrees, ThePresetOfTheThesisShowsThatItIsActive) {
  click("Thesis", 0.1);
  EXPECT_EQ(preset_of(state()), Preset::thesis);
  EXPECT_EQ(subject_.last_choice.tree.per_leaf, 1);
  EXPECT_TRUE(subject_.last_choice.shown.found);
  click("Thesis", 0.1);
  EXPECT_EQ(preset_of(state()), Preset::thesis);
  click("Default", 0.1);
  EXPECT_EQ(preset_of(state()), Preset::product);
  EXPECT_FALSE(subject_.last_choice.shown.found);
}

TEST_F(PanelTrees, TheDemonstrationTakesThreeActionsByMouse) {
  click("Thesis", 0.1);
  click("Orientation test");
  click("Right");
  EXPECT_EQ(preset_of(state()), Preset::thesis);
  ASSERT_TRUE(state().orientation_test);
  EXPECT_EQ(orientation_tests()[*state().orientation_test].name, "right");
  EXPECT_FALSE(state().paused);
  EXPECT_TRUE(state().shown.found);
}

TEST_F(PanelTrees, OptionsOfTreesAreBelowAHeading) {
  EXPECT_EQ(find("Leaf"), nullptr);
  click("Build options");
  for (const Midpoint midpoint : {Midpoint::thesis, Midpoint::centroid, Midpoint::aabb}) {
    if (midpoint != state().tree.midpoint) {
      choose("Midpoint", std::string(soms::name(midpoint)));
    }
    EXPECT_EQ(subject_.last_choice.tree.midpoint, midpoint);
  }
  for (const EmptySide side :
       {EmptySide::stop, EmptySide::next_axis, EmptySide::object_median, EmptySide::chain}) {
    if (side != state().tree.empty_side) {
      choose("Empty side", std::string(soms::name(side)));
    }
    EXPECT_EQ(subject_.last_choice.tree.empty_side, side);
  }
  click("Leaf", 0.01);
  EXPECT_EQ(subject_.last_choice.tree.per_leaf, 1);
  click("Levels", 0.3);
  EXPECT_GT(subject_.last_choice.tree.level, 1);
  choose("Rule", "quick");
  EXPECT_EQ(find("Midpoint"), nullptr);  // has no effect there
  EXPECT_NE(find("Leaf"), nullptr);
}

}  // namespace
}  // namespace soms::view
