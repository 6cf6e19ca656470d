#include "apps/view/control/action.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/preset.h"
#include "apps/view/scene/orientation_menu.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

ViewState in_the_middle() {
  ViewState state;
  state.limits = {7, 5, 100, 3, true, true, true, 4, 200};
  state.paused = false;
  state.level = 3;
  state.frame = 50;
  state.rule = Rule::soms;
  state.traversal = Traversal::alternate;
  state.orientation_test = 1;
  return state;
}

using Check = std::function<bool(const ViewState&)>;

Check moves(const ObjectMove& move) {
  return [move](const ViewState& s) { return s.requests.move == move; };
}

Check looks(Side side) {
  return [side](const ViewState& s) { return s.requests.look_from == side; };
}

/// What each action shall have done to `in_the_middle`, whose opposite holds before.
std::vector<std::pair<Action, Check>> expectations() {
  using S = const ViewState&;
  return {
      {Action::help, [](S s) { return s.help; }},
      {Action::back, [](S s) { return s.requests.quit; }},
      {Action::open, [](S s) { return s.requests.list_files; }},
      {Action::quit, [](S s) { return s.requests.quit; }},
      {Action::panels, [](S s) { return !s.panels; }},
      {Action::fullscreen, [](S s) { return s.requests.fullscreen; }},
      {Action::screenshot, [](S s) { return s.requests.screenshot; }},
      {Action::screenshot_panels, [](S s) { return s.requests.screenshot_panels; }},
      {Action::pause, [](S s) { return s.paused; }},
      {Action::step, [](S s) { return s.paused && s.requests.steps == 1; }},
      {Action::step_back, [](S s) { return s.paused && s.requests.steps == -1; }},
      {Action::faster, [](S s) { return s.speed == 2; }},
      {Action::slower, [](S s) { return s.speed == 0.5; }},
      {Action::first_frame, [](S s) { return s.requests.seek == 0U; }},
      {Action::last_frame, [](S s) { return s.paused && s.requests.seek == 99U; }},
      {Action::reset_camera, [](S s) { return s.requests.fit_all; }},
      {Action::view_front, looks(Side::front)},
      {Action::view_right, looks(Side::right)},
      {Action::view_top, looks(Side::top)},
      {Action::view_corner, looks(Side::corner)},
      {Action::camera_mode, [](S s) { return s.camera == CameraMode::fly; }},
      {Action::next_mover, [](S s) { return s.camera == CameraMode::follow && s.followed == 0; }},
      {Action::previous_mover,
       [](S s) { return s.camera == CameraMode::follow && s.followed == 0; }},
      {Action::focus, [](S s) { return s.requests.fit_object; }},
      {Action::focus_gap, [](S s) { return s.requests.fit_gap; }},
      {Action::events, [](S s) { return s.events; }},
      {Action::event_next, [](S s) { return s.events && s.requests.event_step == 1; }},
      {Action::event_previous, [](S s) { return s.events && s.requests.event_step == -1; }},
      {Action::rule_next, [](S s) { return s.rule == Rule::sah; }},
      {Action::rule_previous, [](S s) { return s.rule == Rule::spatial_median; }},
      {Action::traversal_next, [](S s) { return s.traversal == Traversal::larger; }},
      {Action::traversal_previous, [](S s) { return s.traversal == Traversal::b_first; }},
      {Action::descent_next, [](S s) { return s.traversal == Traversal::e_node; }},
      {Action::descent_previous, [](S s) { return s.traversal == Traversal::e_node; }},
      {Action::thesis, [](S s) { return preset_of(s) == Preset::thesis && s.shown.found; }},
      {Action::orientation_next,
       [](S s) { return s.orientation_test == 2U && s.frame == 0 && s.requests.fit_all; }},
      {Action::orientation_previous, [](S s) { return s.orientation_test == 0U && s.frame == 0; }},
      {Action::tree_boxes, [](S s) { return s.shown.tree_boxes; }},
      {Action::tree_of, [](S s) { return s.tree_of == TreeOf::mover && s.shown.tree_boxes; }},
      {Action::level_down, [](S s) { return s.level == 4 && s.shown.tree_boxes; }},
      {Action::level_up, [](S s) { return s.level == 2 && s.shown.tree_boxes; }},
      {Action::learn, [](S s) { return s.learn; }},
      {Action::learn_next, [](S s) { return s.learn; }},
      {Action::learn_previous, [](S s) { return s.learn; }},
      {Action::visited, [](S s) { return s.shown.visited; }},
      {Action::pruned, [](S s) { return s.shown.pruned; }},
      {Action::found, [](S s) { return s.shown.found; }},
      {Action::pruning, [](S s) { return !s.prune; }},
      {Action::contact_triangles, [](S s) { return !s.shown.contact_triangles; }},
      {Action::crossing_segments, [](S s) { return !s.shown.crossing_segments; }},
      {Action::gap, [](S s) { return !s.shown.gap; }},
      {Action::contact_lines, [](S s) { return s.shown.contact_lines; }},
      {Action::contact_parts, [](S s) { return s.shown.contact_parts; }},
      {Action::contacts_on_top, [](S s) { return s.shown.contacts_on_top; }},
      {Action::edges, [](S s) { return s.shown.edges; }},
      {Action::movers, [](S s) { return !s.shown.movers; }},
      {Action::gizmo, [](S s) { return !s.shown.gizmo; }},
      {Action::object_right, moves({.right = 1})},
      {Action::object_left, moves({.right = -1})},
      {Action::object_forward, moves({.forward = 1})},
      {Action::object_backward, moves({.forward = -1})},
      {Action::object_up, moves({.up = 1})},
      {Action::object_down, moves({.up = -1})},
      {Action::object_right_fine, moves({.right = 1, .scale = 0.1})},
      {Action::object_left_fine, moves({.right = -1, .scale = 0.1})},
      {Action::object_forward_fine, moves({.forward = 1, .scale = 0.1})},
      {Action::object_backward_fine, moves({.forward = -1, .scale = 0.1})},
      {Action::object_up_fine, moves({.up = 1, .scale = 0.1})},
      {Action::object_down_fine, moves({.up = -1, .scale = 0.1})},
      {Action::object_turn_left, moves({.turn = 1})},
      {Action::object_turn_right, moves({.turn = -1})},
      {Action::object_home, [](S s) { return s.requests.object_home; }},
  };
}

TEST(Actions, EachKeyOfTheTableDoesWhatItsRowSays) {
  const auto expected = expectations();
  ASSERT_EQ(expected.size(), actions().size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const ActionRow& row = actions()[i];
    ASSERT_EQ(expected[i].first, row.action) << "row " << i << ": " << row.help;
    for (const KeyPress& press : {row.press, row.other}) {
      if (press.key == Key::none) {
        continue;
      }
      ViewState state = in_the_middle();
      EXPECT_FALSE(expected[i].second(state)) << "before " << row.help;
      const auto action = action_of(press);
      ASSERT_TRUE(action) << name(press);
      apply(state, *action);
      EXPECT_TRUE(expected[i].second(state)) << name(press) << ": " << row.help;
    }
  }
}

TEST(Actions, DescentsGoRoundAmongThoseThatTheTraversalTakes) {
  for (const Traversal traversal : {Traversal::e_node, Traversal::e_node_front}) {
    ViewState state;
    state.traversal = traversal;
    const std::vector<Descent> possible = descents_of(traversal);
    state.descent = possible.front();
    for (std::size_t k = 1; k <= possible.size(); ++k) {
      apply(state, Action::descent_next);
      EXPECT_EQ(state.descent, possible[k % possible.size()]);
    }
    apply(state, Action::descent_previous);
    EXPECT_EQ(state.descent, possible.back());
    EXPECT_EQ(state.traversal, traversal);
  }
  EXPECT_EQ(descents_of(Traversal::e_node).size(), descents().size());
  EXPECT_TRUE(descents_of(Traversal::larger).empty());
}

TEST(Actions, StandInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < actions().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(actions()[i].action), i);
  }
}

TEST(Actions, NoKeyStandsTwiceAndNoneIsAFlyingKey) {
  std::set<std::string> seen;
  for (const ActionRow& row : actions()) {
    ASSERT_NE(row.press.key, Key::none) << row.help;
    EXPECT_TRUE(seen.insert(name(row.press)).second) << name(row.press);
    if (row.other.key != Key::none) {
      EXPECT_TRUE(seen.insert(name(row.other)).second) << name(row.other);
    }
  }
  for (const char* const fly : {"W", "A", "S", "D"}) {
    EXPECT_EQ(seen.count(fly), 0U);
  }
  EXPECT_FALSE(action_of(KeyPress{}));
  EXPECT_FALSE(action_of(KeyPress{key_of('W')}));
  EXPECT_FALSE(action_of(KeyPress{key_of('H'), false, true}));
}

TEST(Actions, EscapeClosesTheHelpThenDropsWhatIsPickedThenQuits) {
  ViewState state;
  state.help = true;
  state.selected = true;
  apply(state, Action::back);
  EXPECT_FALSE(state.help);
  EXPECT_FALSE(state.requests.deselect);
  apply(state, Action::back);
  EXPECT_TRUE(state.requests.deselect);
  EXPECT_FALSE(state.requests.quit);
  state.selected = false;
  apply(state, Action::back);
  EXPECT_TRUE(state.requests.quit);
}

TEST(Actions, SpeedAndLevelStopAtTheirEnds) {
  ViewState state = in_the_middle();
  for (int i = 0; i < 20; ++i) {
    apply(state, Action::faster);
    apply(state, Action::level_down);
  }
  EXPECT_EQ(state.speed, kFastest);
  EXPECT_EQ(state.level, 7);
  for (int i = 0; i < 20; ++i) {
    apply(state, Action::slower);
    apply(state, Action::level_up);
  }
  EXPECT_EQ(state.speed, kSlowest);
  EXPECT_EQ(state.level, 1);
}

TEST(Actions, CyclesComeRoundAndBack) {
  ViewState state = in_the_middle();
  for (std::size_t i = 0; i < rules().size(); ++i) {
    apply(state, Action::rule_next);
  }
  EXPECT_EQ(state.rule, Rule::soms);
  for (int i = 0; i < 10; ++i) {
    apply(state, Action::traversal_previous);
  }
  EXPECT_EQ(state.traversal, Traversal::alternate);
  state.orientation_test.reset();
  for (std::size_t i = 0; i < orientation_tests().size(); ++i) {
    apply(state, Action::orientation_next);
    EXPECT_EQ(state.orientation_test, i);
  }
  apply(state, Action::orientation_next);
  EXPECT_FALSE(state.orientation_test);
  apply(state, Action::orientation_previous);
  EXPECT_EQ(state.orientation_test, orientation_tests().size() - 1);
}

TEST(Actions, FollowsMoversInTurnAndNoneWhereThereIsNone) {
  ViewState state = in_the_middle();
  apply(state, Action::next_mover);
  apply(state, Action::next_mover);
  EXPECT_EQ(state.followed, 1U);
  apply(state, Action::previous_mover);
  apply(state, Action::previous_mover);
  EXPECT_EQ(state.followed, 2U);
  ViewState empty;
  apply(empty, Action::next_mover);
  EXPECT_EQ(empty.camera, CameraMode::orbit);
  apply(empty, Action::camera_mode);
  apply(empty, Action::camera_mode);
  EXPECT_EQ(empty.camera, CameraMode::orbit);
}

TEST(Actions, AskNothingOfAnObjectThatIsNotThereNorOfTimeThatCannotGoBack) {
  ViewState state;
  apply(state, Action::object_right);
  apply(state, Action::object_home);
  apply(state, Action::step_back);
  apply(state, Action::last_frame);
  EXPECT_EQ(state.requests.move, ObjectMove{});
  EXPECT_FALSE(state.requests.object_home);
  EXPECT_EQ(state.requests.steps, 0);
  EXPECT_FALSE(state.requests.seek);
  apply(state, Action::first_frame);
  EXPECT_TRUE(state.requests.restart);
}

TEST(Actions, OnlyStepsAndMovesRepeatWhileAKeyIsHeld) {
  EXPECT_TRUE(repeats(Action::object_right));
  EXPECT_TRUE(repeats(Action::object_turn_right));
  EXPECT_TRUE(repeats(Action::step));
  EXPECT_TRUE(repeats(Action::level_down));
  EXPECT_FALSE(repeats(Action::object_home));
  EXPECT_FALSE(repeats(Action::pause));
  EXPECT_FALSE(repeats(Action::quit));
}

}  // namespace
}  // namespace soms::view
