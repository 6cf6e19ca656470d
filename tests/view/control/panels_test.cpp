#include "apps/view/control/panels.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/help.h"
#include "apps/view/scene/orientation_menu.h"
#include "tests/support/support.h"
#include "tests/view/control/panels_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace soms::view {
namespace {

TEST_F(PanelsTest, EachSwitchFlipsWhatItSaysAndFlipsItBack) {
  const std::vector<std::pair<std::string, std::function<bool()>>> switches{
      {"Touching", [&] { return state().shown.contact_triangles; }},
      {"Crossings", [&] { return state().shown.crossing_segments; }},
      {"Lines", [&] { return state().shown.contact_lines; }},
      {"Movers", [&] { return state().shown.movers; }},
      {"Edges", [&] { return state().shown.edges; }},
      {"Visited", [&] { return state().shown.visited; }},
      {"Pruned", [&] { return state().shown.pruned; }},
      {"Found", [&] { return state().shown.found; }},
      {"Pruning", [&] { return state().prune; }},
      {"Parts", [&] { return state().shown.contact_parts; }},
      {"On top", [&] { return state().shown.contacts_on_top; }},
      {"Handles", [&] { return state().shown.gizmo; }},
      {"Boxes", [&] { return state().shown.tree_boxes; }},
  };
  for (const auto& [label, value] : switches) {
    const bool before = value();
    click(label, 0.1);
    EXPECT_NE(value(), before) << label;
    click(label, 0.1);
    EXPECT_EQ(value(), before) << label;
  }
}

TEST_F(PanelsTest, EachRuleCanBeChosen) {
  for (const RuleEntry& rule : rules()) {
    if (rule.rule != state().rule) {
      choose("Rule", std::string(rule.kebab));
    }
    EXPECT_EQ(state().rule, rule.rule);
    EXPECT_EQ(subject_.last_choice.rule, rule.rule);
  }
}

TEST_F(PanelsTest, EachTraversalCanBeChosen) {
  for (const TraversalEntry& traversal : traversals()) {
    if (traversal.traversal != state().traversal) {
      choose("Traversal", std::string(traversal.kebab));
    }
    EXPECT_EQ(state().traversal, traversal.traversal);
  }
}

TEST_F(PanelsTest, TreeOfTheCityOrTheObject) {
  click("Object", 0.1);
  EXPECT_EQ(state().tree_of, TreeOf::mover);
  EXPECT_TRUE(state().shown.tree_boxes);
  click("Object", 0.1);
  EXPECT_EQ(state().tree_of, TreeOf::mover);
  click("City", 0.1);
  EXPECT_EQ(state().tree_of, TreeOf::city);
}

TEST_F(PanelsTest, LevelSlidesOverTheLevelsOfTheTree) {
  click("Level", 0.3);
  EXPECT_GT(state().level, 1);
  click("Level", 0.01);
  EXPECT_EQ(state().level, 1);
  EXPECT_TRUE(state().shown.tree_boxes);
  const double slider = 0.52 * 19.5 * 13 / (find("Level")->right - find("Level")->left);
  click("Level", slider * 0.98);
  EXPECT_EQ(state().level, 7);
}

TEST_F(PanelsTest, RunPauseStepBackAndStart) {
  click("Run###run");
  EXPECT_FALSE(state().paused);
  const std::uint64_t running = subject_.frame;
  EXPECT_GT(running, 0U);
  click("Pause###run");
  EXPECT_TRUE(state().paused);
  const std::uint64_t paused = subject_.frame;
  click("Step");
  EXPECT_EQ(subject_.frame, paused + 1);
  click("Back");
  EXPECT_EQ(subject_.frame, paused);
  click("Start");
  EXPECT_EQ(subject_.frame, 0U);
}

TEST_F(PanelsTest, SpeedAndFrameSlide) {
  click("Speed", 0.02);
  EXPECT_LT(state().speed, 0.2);
  const double slider =
      0.52 * 19.5 * 14 / (find("Frame")->right - find("Frame")->left);  // 14: the font's height
  click("Frame", slider * 0.5);
  EXPECT_NEAR(static_cast<double>(subject_.frame), 50, 3);
  click("Frame", slider * 0.02);
  EXPECT_EQ(subject_.frame, 0U);
}

TEST_F(PanelsTest, ASimulationWithoutEndHasNoSlider) {
  subject_.frames = 0;
  subject_.can_seek = false;
  settle();
  EXPECT_EQ(find("Frame"), nullptr);
  EXPECT_EQ(find("Back"), nullptr);
  EXPECT_NE(find("Step"), nullptr);
}

TEST_F(PanelsTest, OrientationTestsAreAMenu) {
  const auto tests = orientation_tests();
  ASSERT_GE(tests.size(), 4U);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    click("Orientation test");
    click(std::string(tests[i].title));
    EXPECT_EQ(state().orientation_test, i);
    EXPECT_FALSE(state().paused);
    state().paused = true;
  }
  click("Orientation test");
  click("none");
  EXPECT_FALSE(state().orientation_test);
}

TEST_F(PanelsTest, CameraMenuSetsSidesAndModes) {
  const Camera before = session_.camera();
  click("Camera");
  click("Above");
  for (int i = 0; i < 40; ++i) {
    frame();
  }
  EXPECT_NE(session_.camera(), before);
  EXPECT_LT(view::frame(session_.camera()).forward.z, -0.99);
  for (const CameraMode mode : {CameraMode::fly, CameraMode::follow, CameraMode::orbit}) {
    click("Camera");
    click(name(mode));
    EXPECT_EQ(state().camera, mode);
  }
  for (const char* const row :
       {"Show everything", "Go to the selection", "Front", "Right", "Corner"}) {
    const Camera camera = session_.camera();
    click("Camera");
    click(row);
    for (int i = 0; i < 40; ++i) {
      frame();
    }
    EXPECT_NE(session_.camera(), camera) << row;
  }
}

TEST_F(PanelsTest, FileAndHelpMenusDoAsTheirKeys) {
  click("File");
  click("Save picture");
  EXPECT_TRUE(state().requests.screenshot);
  click("File");
  click("Save with panels");
  EXPECT_TRUE(state().requests.screenshot_panels);
  click("File");
  click("Full screen");
  EXPECT_TRUE(state().requests.fullscreen);
  click("Help");
  click("Keys");
  EXPECT_TRUE(state().help);
  state().help = false;
  click("File");
  click("Quit");
  EXPECT_TRUE(state().requests.quit);
}

TEST_F(PanelsTest, AFileIsChosenFromTheListByTheMouse) {
  const soms::test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "inner");
  std::ofstream(folder.path() / "inner" / "cube.ply") << "x";
  state().files.emplace(folder.path());
  settle();
  click("inner/", 0.1);
  EXPECT_EQ(state().files->chosen(), 0U);
  click("inner/", 0.1);  // twice: it is entered
  click("cube.ply", 0.1);
  EXPECT_TRUE(subject_.opened.empty());
  click("Open");
  ASSERT_EQ(subject_.opened.size(), 1U);
  EXPECT_EQ(std::filesystem::path(subject_.opened[0]).filename(), "cube.ply");
  EXPECT_EQ(find("Cancel"), nullptr);
  click("File");
  click("Open...");
  click("Folder above");
  EXPECT_EQ(state().files->folder(), std::filesystem::weakly_canonical(folder.path()));
  click("Cancel");
  EXPECT_FALSE(state().files);
}

TEST_F(PanelsTest, EscapeClosesAnOpenListAndDoesNotQuit) {
  click("Rule", 0.2);
  ASSERT_NE(find("sah"), nullptr);
  EXPECT_TRUE(captured().keys);
  session_.push(KeyDown{{Key::escape}});
  ImGui::GetIO().KeysDown[1] = true;
  frame();
  ImGui::GetIO().KeysDown[1] = false;
  settle();
  EXPECT_EQ(find("sah"), nullptr);
  EXPECT_FALSE(state().requests.quit);
}

TEST_F(PanelsTest, HeadingsFold) {
  ASSERT_NE(find("Rule"), nullptr);
  click("Tree and traversal");
  EXPECT_EQ(find("Rule"), nullptr);
  click("Tree and traversal");
  EXPECT_NE(find("Rule"), nullptr);
}

TEST_F(PanelsTest, WhatIsPickedHasAPanelThatGoesThereAndCloses) {
  EXPECT_EQ(find("Go there"), nullptr);
  ImGui::GetIO().MousePos = ImVec2(700, 450);
  session_.push(MouseDown{MouseButton::left, {700, 450}});
  session_.push(MouseUp{MouseButton::left, {700, 450}});
  settle();
  ASSERT_TRUE(session_.picked());
  ASSERT_NE(find("Go there"), nullptr);
  const Camera before = session_.camera();
  click("Go there");
  EXPECT_NE(session_.camera(), before);
  click("Close");
  EXPECT_FALSE(session_.picked());
  EXPECT_EQ(find("Go there"), nullptr);
}

TEST_F(PanelsTest, PanelsAreNotThroughWhichTheSceneIsClicked) {
  const WidgetPlace place = *find("Edges");
  ImGui::GetIO().MousePos = ImVec2(static_cast<float>(place.left), static_cast<float>(place.top));
  frame();
  EXPECT_TRUE(captured().mouse);
  ImGui::GetIO().MousePos = ImVec2(900, 400);
  frame();
  frame();
  EXPECT_FALSE(captured().mouse);
}

TEST_F(PanelsTest, WidgetsLieWithinTheWindowAndDoNotCoverEachOther) {
  for (const ImVec2 size : {ImVec2(1280, 720), ImVec2(960, 540)}) {
    ImGui::GetIO().DisplaySize = size;
    settle();
    const auto& places = panels_.places();
    ASSERT_GT(places.size(), 20U);
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_GE(places[i].left, 0) << places[i].label;
      const bool in_bar = places[i].top < 20;
      EXPECT_LE(places[i].right, in_bar ? 500 : 300) << places[i].label;
      for (std::size_t j = 0; j < i; ++j) {
        const bool apart = places[i].left >= places[j].right || places[j].left >= places[i].right ||
                           places[i].top >= places[j].bottom || places[j].top >= places[i].bottom;
        EXPECT_TRUE(apart) << places[i].label << " over " << places[j].label;
      }
    }
  }
}

TEST_F(PanelsTest, ShowNothingWhenSwitchedOff) {
  state().panels = false;
  settle();
  EXPECT_TRUE(panels_.places().empty());
  ImGui::GetIO().MousePos = ImVec2(20, 200);
  frame();
  frame();
  EXPECT_FALSE(captured().mouse);
}

TEST_F(PanelsTest, DrawEveryStateWithoutComplaint) {
  subject_.note = "The recording ends early: 12 of 100 frames can be read.";
  drawn_.triangles_left = 800'000;
  subject_.gap = GapFacts{
      "0.1235",
      {{"Gap", "0.123457"}, {"from triangle", "12 of city.ply"}, {"to triangle", "4 of car.ply"}},
      {}};
  subject_.left_out = {"2,000 of 12,345 contacts", "50,000 of 1,000,000 boxes"};
  times_.add(16.6, 1.0 / 60);
  session_.set_message("broken.ply, line 3: no vertices; repair the file");
  for (const bool help : {false, true}) {
    for (const CameraMode mode : {CameraMode::orbit, CameraMode::fly, CameraMode::follow}) {
      state().help = help;
      state().camera = mode;
      settle();
      EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 1000);
    }
  }
}

TEST_F(PanelsTest, CountGapsWhereThereIsAClearance) {
  const auto drawn = [&] {
    settle();
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  click("Show");  // folded, so that all counts are within the window
  const int without = drawn();
  subject_.clearance = "0.5 m";
  const int none = drawn();
  subject_.least_gap = "0.1234 m";
  const int some = drawn();
  EXPECT_GT(none, without);
  EXPECT_GT(some, none);  // "0.1234 m" has more letters than "none"
}

TEST_F(PanelsTest, TheGapTakesThreeRowsWhereThereIsOne) {
  const double before = find("Drawing")->top;
  subject_.gap = GapFacts{
      "0.1235",
      {{"Gap", "0.123457"}, {"from triangle", "12 of city.ply"}, {"to triangle", "4 of car.ply"}},
      {}};
  settle();
  const double rows = (find("Drawing")->top - before) / ImGui::GetTextLineHeight();
  EXPECT_GT(rows, 3);
  EXPECT_LT(rows, 6);
  click("Gap", 0.1);
  EXPECT_FALSE(state().shown.gap);
  subject_.gap.reset();
  settle();
  EXPECT_EQ(find("Drawing")->top, before);
}

TEST_F(PanelsTest, TipsTellTheKey) {
  const auto tip_is_shown = [] { return ImGui::GetDrawData()->CmdListsCount; };
  const int before = tip_is_shown();
  const WidgetPlace place = *find("Edges");
  ImGui::GetIO().MousePos =
      ImVec2(static_cast<float>(place.left + 3), static_cast<float>(place.top + 3));
  settle();
  EXPECT_EQ(tip_is_shown(), before + 1);
}

}  // namespace
}  // namespace soms::view
