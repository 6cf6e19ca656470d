// Panels that are lists: events, the tests of a traversal.
#include "apps/view/control/action.h"
#include "apps/view/control/opening_panel.h"
#include "apps/view/control/panel_text.h"
#include "tests/support/support.h"
#include "tests/view/control/panels_fixture.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace soms::view {
namespace {

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

TEST_F(PanelsTest, TheListOfFilesTakesAPath) {
  const soms::test::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.ply") << "x";
  state().files.emplace(std::filesystem::temp_directory_path());
  settle();
  click("##path", 0.9);
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Enter] = 2;
  io.KeyMap[ImGuiKey_A] = 3;
  io.KeysDown[3] = io.KeyCtrl = true;  // all of the field
  frame();
  io.KeysDown[3] = io.KeyCtrl = false;
  io.AddInputCharactersUTF8((folder.path() / "a.ply").string().c_str());
  frame();
  EXPECT_TRUE(state().files) << "letters are the field's";
  io.KeysDown[2] = true;
  frame();
  io.KeysDown[2] = false;
  settle();
  EXPECT_FALSE(state().files);
  ASSERT_EQ(subject_.opened.size(), 1U);
  EXPECT_EQ(std::filesystem::path(subject_.opened[0]).filename(), "a.ply");
}

TEST_F(PanelsTest, BeforeThereIsASceneALineSaysWhatIsDone) {
  const auto drawn = [](const std::string& doing, double share) {
    ImGui::NewFrame();
    draw_opening(doing, share);
    ImGui::Render();
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  (void)drawn("reading town.ply", -1);
  const int line = drawn("reading town.ply", -1);
  EXPECT_GT(line, 4 * 14);  // each letter is a rectangle
  EXPECT_GT(drawn("reading town.ply", 0.5), line) << "a bar, where a share is known";
}

}  // namespace
}  // namespace soms::view
