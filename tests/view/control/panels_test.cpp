#include "apps/view/control/panels.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/help.h"
#include "apps/view/control/imgui_input.h"
#include "apps/view/control/panel_text.h"
#include "apps/view/control/style.h"
#include "apps/view/scene/orientation_menu.h"
#include "tests/support/support.h"
#include "tests/view/control/mock_subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace soms::view {
namespace {

/// Dear ImGui without a window or OpenGL: draws the panels of a session and clicks their widgets.
class PanelsTest : public testing::Test {
 protected:
  void SetUp() override {
    IMGUI_CHECKVERSION();
    context_ = ImGui::CreateContext();
    set_style(1);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(1280, 720);
    io.DeltaTime = 1.0F / 60;
    io.KeyMap[ImGuiKey_Escape] = 1;
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    session_.state().paused = true;
    settle();
  }

  void TearDown() override { ImGui::DestroyContext(context_); }

  void frame() {
    ImGui::NewFrame();
    session_.handle(captured());
    session_.tick(1.0 / 60);
    panels_.draw(session_, times_, drawn_);
    ImGui::Render();
  }

  void settle() {
    for (int i = 0; i < 3; ++i) {
      frame();
    }
  }

  [[nodiscard]] const WidgetPlace* find(const std::string& label) const {
    const auto& places = panels_.places();
    const auto found = std::find_if(places.begin(), places.end(),
                                    [&](const WidgetPlace& p) { return p.label == label; });
    return found == places.end() ? nullptr : &*found;
  }

  /// Presses and releases the left button over a part of a widget: 0 is its left end, 1 its right.
  void click(const std::string& label, double part = 0.5) {
    const WidgetPlace* const place = find(label);
    ASSERT_NE(place, nullptr) << label;
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = ImVec2(static_cast<float>(place->left + part * (place->right - place->left)),
                         static_cast<float>((place->top + place->bottom) / 2));
    frame();
    io.MouseDown[0] = true;
    frame();
    io.MouseDown[0] = false;
    settle();
  }

  void choose(const std::string& list, const std::string& row) {
    click(list, 0.2);
    click(row);
  }

  ViewState& state() { return session_.state(); }

  ImGuiContext* context_ = nullptr;
  MockSubject subject_;
  Session session_{subject_, {1280, 720}};
  FrameTimes times_;
  DrawStatistics drawn_;
  Panels panels_;
};

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

TEST_F(PanelsTest, EventsAreListedSearchedAndGoneTo) {
  click("Events");
  click("List");
  for (int i = 0; i < 5; ++i) {
    frame();
  }
  const auto row = [&](const std::string& name) {
    const auto& places = panels_.places();
    return std::find_if(places.begin(), places.end(), [&](const WidgetPlace& p) {
      return p.label.find(name) != std::string::npos;
    });
  };
  ASSERT_NE(row("house"), panels_.places().end());
  EXPECT_EQ(row("house")->label,
            "car (mover 1) touches house\n   frames 3 to 9, at most 12 pairs, in frame 5");
  ASSERT_NE(row("tree"), panels_.places().end());
  const std::string tree = row("tree")->label;
  EXPECT_EQ(tree, "person (mover 2) touches tree\n   frame 7, at most 1 pair, in frame 7");
  click(tree);
  EXPECT_EQ(state().event, 1U);
  EXPECT_EQ(subject_.frame, 7U);
  click("Previous");
  EXPECT_EQ(state().event, 0U);
  click("##search");
  for (const char c : std::string("TREE person")) {
    ImGui::GetIO().AddInputCharacter(static_cast<unsigned int>(c));
  }
  settle();
  EXPECT_TRUE(captured().keys);
  EXPECT_EQ(row("house"), panels_.places().end());
  EXPECT_NE(row("tree"), panels_.places().end());
}

TEST_F(PanelsTest, OfALongListOfEventsOnlyRowsInSightAreWritten) {
  subject_.rows.clear();
  for (std::uint64_t i = 0; i < 5'000; ++i) {
    subject_.rows.push_back({"car " + std::to_string(i) + " touches house", i, i, 1, i});
  }
  state().events = true;
  for (int i = 0; i < 5; ++i) {
    frame();
  }
  const auto listed = [&](const std::string& name) {
    const auto& places = panels_.places();
    return std::count_if(places.begin(), places.end(), [&](const WidgetPlace& p) {
      return p.label.find(name) != std::string::npos;
    });
  };
  EXPECT_EQ(listed("car 0 touches"), 1);
  EXPECT_GT(listed(" touches house"), 3);
  EXPECT_LT(listed(" touches house"), 20);
  EXPECT_EQ(listed("car 4000 touches"), 0);
  state().requests.event = 4'000;  // the list goes to the row that is chosen
  settle();
  EXPECT_EQ(listed("car 4000 touches"), 1);
  EXPECT_EQ(listed("car 0 touches"), 0);
  EXPECT_LT(listed(" touches house"), 20);
}

TEST_F(PanelsTest, KeysOfListsShowThemThoughPanelsAreHidden) {
  for (const Action action : {Action::events, Action::learn, Action::learn_next}) {
    state().panels = false;
    state().events = action != Action::learn;
    state().learn = action == Action::learn;
    apply(state(), action);
    settle();
    EXPECT_TRUE(state().panels);
    EXPECT_EQ(find("Next test") != nullptr, action != Action::events);
    EXPECT_EQ(find("Next") != nullptr, action != Action::learn);
    state().events = state().learn = false;
  }
}

TEST_F(PanelsTest, WithoutPanelsALineSaysWhichEventIsSeen) {
  state().panels = false;
  settle();
  EXPECT_EQ(event_line(state(), session_.events()), "");
  const int before = ImGui::GetDrawData()->TotalVtxCount;
  apply(state(), Action::event_next);
  frame();
  EXPECT_EQ(event_line(state(), session_.events()), "10 of 20 frames searched");
  settle();
  EXPECT_FALSE(state().panels);
  EXPECT_EQ(event_line(state(), session_.events()),
            "event 1 of 2: car (mover 1) touches house, frames 3 to 9");
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, before + 100);
  state().requests.deselect = true;
  settle();
  EXPECT_EQ(event_line(state(), session_.events()), "");
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

TEST_F(PanelsTest, TestsOfATraversalHaveAPanel) {
  click("Learn");
  click("Traversal, test by test");
  EXPECT_TRUE(state().learn);
  click("Next test");
  EXPECT_EQ(state().learn_step, 1U);
  click("Previous test");
  EXPECT_EQ(state().learn_step, 0U);
  click("##test", 0.98);
  EXPECT_EQ(state().learn_step, 11U);
  subject_.learn_tests = 0;
  settle();
  EXPECT_EQ(find("Next test"), nullptr);
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
