#include "apps/view/control/action.h"

#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "apps/view/control/preset.h"
#include "apps/view/scene/orientation_menu.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace soms::view {

namespace {

constexpr KeyPress key(char character) {
  return {key_of(character)};
}

constexpr KeyPress shift(char character) {
  return {key_of(character), true, false};
}

constexpr KeyPress control(char character) {
  return {key_of(character), false, true};
}

constexpr std::string_view kGeneral = "General";
constexpr std::string_view kTime = "Time";
constexpr std::string_view kCamera = "Camera";
constexpr std::string_view kEvents = "Events";
constexpr std::string_view kTree = "Tree and traversal";
constexpr std::string_view kLearn = "Learn";
constexpr std::string_view kShow = "Show";
constexpr std::string_view kObject = "Move the object";

constexpr std::array<ActionRow, 72> kActions{{
    {Action::help, key('H'), {Key::f1}, kGeneral, "this help"},
    {Action::back, {Key::escape}, {}, kGeneral, "close what is open, deselect, quit"},
    {Action::open, control('O'), {}, kGeneral, "open a model"},
    {Action::quit, control('Q'), {}, kGeneral, "quit"},
    {Action::panels, {Key::tab}, {}, kGeneral, "panels on or off"},
    {Action::fullscreen, {Key::f11}, {}, kGeneral, "full screen on or off"},
    {Action::screenshot, {Key::f12}, {}, kGeneral, "save the picture as PNG"},
    {Action::screenshot_panels, {Key::f12, true}, {}, kGeneral, "save it with the panels"},

    {Action::pause, key(' '), {}, kTime, "run or pause"},
    {Action::step, key('.'), {}, kTime, "pause, one frame forward"},
    {Action::step_back, key(','), {}, kTime, "pause, one frame back"},
    {Action::faster, key('='), shift('='), kTime, "twice as fast"},
    {Action::slower, key('-'), {}, kTime, "half as fast"},
    {Action::first_frame, {Key::home}, {}, kTime, "to the first frame"},
    {Action::last_frame, {Key::end}, {}, kTime, "to the last frame"},

    {Action::reset_camera, {Key::enter}, {}, kCamera, "show everything"},
    {Action::view_front, key('1'), {}, kCamera, "from the front"},
    {Action::view_right, key('3'), {}, kCamera, "from the right"},
    {Action::view_top, key('7'), {}, kCamera, "from above"},
    {Action::view_corner, key('9'), {}, kCamera, "from a corner"},
    {Action::camera_mode, key('C'), {}, kCamera, "orbit, fly (W A S D), follow a mover"},
    {Action::next_mover, key('M'), {}, kCamera, "follow the next mover"},
    {Action::previous_mover, shift('M'), {}, kCamera, "follow the previous mover"},
    {Action::focus, key('F'), {}, kCamera, "go to the selection"},
    {Action::focus_gap, shift('F'), {}, kCamera, "go to the gap"},

    {Action::events, {Key::f2}, {}, kEvents, "list of events on or off"},
    {Action::event_next, {Key::f3}, {}, kEvents, "go to the next event"},
    {Action::event_previous, {Key::f3, true}, {}, kEvents, "go to the previous event"},

    {Action::rule_next, key('R'), {}, kTree, "next rule"},
    {Action::rule_previous, shift('R'), {}, kTree, "previous rule"},
    {Action::traversal_next, key('T'), {}, kTree, "next traversal"},
    {Action::traversal_previous, shift('T'), {}, kTree, "previous traversal"},
    {Action::descent_next, key('Q'), {}, kTree, "next descent of E-Node"},
    {Action::descent_previous, shift('Q'), {}, kTree, "previous descent of E-Node"},
    {Action::thesis, key('Z'), {}, kTree, "tree, traversal and boxes of the thesis"},
    {Action::orientation_next, key('O'), {}, kTree, "next orientation test"},
    {Action::orientation_previous, shift('O'), {}, kTree, "previous orientation test"},
    {Action::tree_boxes, key('B'), {}, kTree, "boxes of one level of the tree"},
    {Action::tree_of, shift('B'), {}, kTree, "tree of the city or of the object"},
    {Action::level_down, key(']'), {}, kTree, "one level deeper"},
    {Action::level_up, key('['), {}, kTree, "one level up, toward the root"},

    {Action::learn, {Key::f4}, {}, kLearn, "the traversal test by test, on or off"},
    {Action::learn_next, {Key::f5}, {}, kLearn, "next test"},
    {Action::learn_previous, {Key::f5, true}, {}, kLearn, "previous test"},

    {Action::visited, key('V'), {}, kShow, "boxes that the traversal visited"},
    {Action::pruned, key('P'), {}, kShow, "boxes that it pruned"},
    {Action::found, key('N'), {}, kShow, "boxes that it found"},
    {Action::pruning, key('U'), {}, kShow, "with or without pruning"},
    {Action::contact_triangles, key('X'), {}, kShow, "triangles that touch"},
    {Action::crossing_segments, key('G'), {}, kShow, "segments in which they cross"},
    {Action::gap, shift('G'), {}, kShow, "nearest points of the object, with the gap"},
    {Action::contact_lines, key('L'), {}, kShow, "lines from bodies to contacts"},
    {Action::contact_parts, key('J'), {}, kShow, "parts that touch"},
    {Action::contacts_on_top, key('I'), {}, kShow, "contacts drawn on top of everything"},
    {Action::edges, key('E'), {}, kShow, "edges of triangles"},
    {Action::movers, key('Y'), {}, kShow, "movers"},
    {Action::gizmo, key('K'), {}, kShow, "handles of the object"},

    {Action::object_right, {Key::right}, {}, kObject, "right"},
    {Action::object_left, {Key::left}, {}, kObject, "left"},
    {Action::object_forward, {Key::up}, {}, kObject, "away"},
    {Action::object_backward, {Key::down}, {}, kObject, "near"},
    {Action::object_up, {Key::page_up}, {}, kObject, "up"},
    {Action::object_down, {Key::page_down}, {}, kObject, "down"},
    {Action::object_right_fine, {Key::right, true}, {}, kObject, "right, a tenth of a step"},
    {Action::object_left_fine, {Key::left, true}, {}, kObject, "left, a tenth of a step"},
    {Action::object_forward_fine, {Key::up, true}, {}, kObject, "away, a tenth of a step"},
    {Action::object_backward_fine, {Key::down, true}, {}, kObject, "nearer, a tenth of a step"},
    {Action::object_up_fine, {Key::page_up, true}, {}, kObject, "up, a tenth of a step"},
    {Action::object_down_fine, {Key::page_down, true}, {}, kObject, "down, a tenth of a step"},
    {Action::object_turn_left, {Key::left, false, true}, {}, kObject, "turn left by 5 degrees"},
    {Action::object_turn_right, {Key::right, false, true}, {}, kObject, "turn right by 5 degrees"},
    {Action::object_home, {Key::backspace}, {}, kObject, "back to where it was"},
}};

/// The value `by` places on in a cycle of `count` enumerators that start at 0.
template <typename Enum>
Enum cycled(Enum value, int by, int count) {
  return static_cast<Enum>((static_cast<int>(value) + by + count) % count);
}

/// The entry `by` places on in a table that has the order of its enumeration, and round.
template <typename Enum, typename Entry>
Enum cycled(Enum value, int by, std::span<const Entry> table) {
  return cycled(value, by, static_cast<int>(table.size()));
}

/// None, then the tests in order, and round. Each needs an object.
void cycle_orientation(ViewState& state, bool forward) {
  if (!state.limits.has_object) {
    return;
  }
  const std::size_t places = orientation_tests().size() + 1;
  const std::size_t now = state.orientation_test ? *state.orientation_test + 1 : 0;
  const std::size_t next = (now + (forward ? 1 : places - 1)) % places;
  set_orientation_test(state, next == 0 ? std::nullopt : std::optional(next - 1));
}

/// Through those that the traversal takes. A traversal without a descent makes room for E-Node.
void cycle_descent(ViewState& state, int by) {
  if (!has_descent(state.traversal)) {
    state.traversal = Traversal::e_node;
    return;
  }
  const std::vector<Descent> possible = descents_of(state.traversal);
  const auto now =
      std::find(possible.begin(), possible.end(), descent_of(state)) - possible.begin();
  const auto count = static_cast<std::ptrdiff_t>(possible.size());
  state.descent = possible[static_cast<std::size_t>((now + by + count) % count)];
}

void step(ViewState& state, int by) {
  state.paused = true;
  state.requests.steps += by;
}

void follow(ViewState& state, int by) {
  const std::uint64_t count = state.limits.movers;
  if (count == 0) {
    return;
  }
  if (state.camera == CameraMode::follow) {
    state.followed = (state.followed + (by > 0 ? 1 : count - 1)) % count;
  }
  state.camera = CameraMode::follow;
}

void next_camera(ViewState& state) {
  state.camera = cycled(state.camera, 1, 3);
  if (state.camera == CameraMode::follow && state.limits.movers == 0) {
    state.camera = CameraMode::orbit;
  }
}

void back(ViewState& state) {
  if (state.files) {
    state.files.reset();
  } else if (state.help) {
    state.help = false;
  } else if (state.learn) {
    state.learn = false;
  } else if (state.events && state.panels) {
    state.events = false;
  } else if (state.selected) {
    state.requests.deselect = true;
  } else {
    state.requests.quit = true;
  }
}

void seek_end(ViewState& state) {
  if (state.limits.can_seek && state.limits.frames > 0) {
    state.paused = true;
    state.requests.seek = state.limits.frames - 1;
  }
}

void seek_start(ViewState& state) {
  if (state.limits.can_seek) {
    state.requests.seek = 0;
  } else {
    state.requests.restart = true;
  }
}

void flip(bool& flag) {
  flag = !flag;
}

/// Actions of time, window and camera. False: it is none of them.
bool apply_general(ViewState& state, Action action) {
  switch (action) {
    case Action::help:
      flip(state.help);
      return true;
    case Action::back:
      back(state);
      return true;
    case Action::open:
      state.requests.list_files = true;
      return true;
    case Action::quit:
      state.requests.quit = true;
      return true;
    case Action::panels:
      flip(state.panels);
      return true;
    case Action::fullscreen:
      state.requests.fullscreen = true;
      return true;
    case Action::screenshot:
      state.requests.screenshot = true;
      return true;
    case Action::screenshot_panels:
      state.requests.screenshot_panels = true;
      return true;
    case Action::pause:
      flip(state.paused);
      return true;
    case Action::step:
      step(state, 1);
      return true;
    case Action::step_back:
      if (state.limits.can_seek) {
        step(state, -1);
      }
      return true;
    case Action::faster:
      state.speed = std::min(state.speed * 2, kFastest);
      return true;
    case Action::slower:
      state.speed = std::max(state.speed / 2, kSlowest);
      return true;
    case Action::first_frame:
      seek_start(state);
      return true;
    case Action::last_frame:
      seek_end(state);
      return true;
    default:
      return false;
  }
}

bool apply_camera(ViewState& state, Action action) {
  switch (action) {
    case Action::reset_camera:
      state.requests.fit_all = true;
      return true;
    case Action::view_front:
      state.requests.look_from = Side::front;
      return true;
    case Action::view_right:
      state.requests.look_from = Side::right;
      return true;
    case Action::view_top:
      state.requests.look_from = Side::top;
      return true;
    case Action::view_corner:
      state.requests.look_from = Side::corner;
      return true;
    case Action::camera_mode:
      next_camera(state);
      return true;
    case Action::next_mover:
      follow(state, 1);
      return true;
    case Action::previous_mover:
      follow(state, -1);
      return true;
    case Action::focus:
      state.requests.fit_object = true;
      return true;
    case Action::focus_gap:
      state.requests.fit_gap = true;
      return true;
    default:
      return false;
  }
}

/// Of hidden panels, one that is called is shown with the others.
void flip_panel(ViewState& state, bool& panel) {
  panel = !panel || !state.panels;
  state.panels = state.panels || panel;
}

bool apply_list(ViewState& state, Action action) {
  switch (action) {
    case Action::events:
      flip_panel(state, state.events);
      return true;
    case Action::event_next:
    case Action::event_previous:
      state.events = true;
      state.requests.event_step = action == Action::event_next ? 1 : -1;
      return true;
    case Action::learn:
      flip_panel(state, state.learn);
      return true;
    case Action::learn_next:
    case Action::learn_previous:
      if (state.learn && action == Action::learn_next) {
        ++state.learn_step;
      } else if (state.learn && state.learn_step > 0) {
        --state.learn_step;
      }
      state.learn = state.panels = true;
      return true;
    default:
      return false;
  }
}

bool apply_tree(ViewState& state, Action action) {
  switch (action) {
    case Action::rule_next:
    case Action::rule_previous:
      state.rule = cycled(state.rule, action == Action::rule_next ? 1 : -1, rules());
      return true;
    case Action::traversal_next:
    case Action::traversal_previous:
      state.traversal =
          cycled(state.traversal, action == Action::traversal_next ? 1 : -1, traversals());
      return true;
    case Action::descent_next:
    case Action::descent_previous:
      cycle_descent(state, action == Action::descent_next ? 1 : -1);
      return true;
    case Action::thesis:
      choose(state, Preset::thesis);
      return true;
    case Action::orientation_next:
    case Action::orientation_previous:
      cycle_orientation(state, action == Action::orientation_next);
      return true;
    case Action::tree_boxes:
      flip(state.shown.tree_boxes);
      return true;
    case Action::tree_of:
      state.tree_of = cycled(state.tree_of, 1, 2);
      state.level = std::min(state.level, levels(state));
      state.shown.tree_boxes = true;
      return true;
    case Action::level_down:
    case Action::level_up:
      state.level =
          std::clamp(state.level + (action == Action::level_down ? 1 : -1), 1, levels(state));
      state.shown.tree_boxes = true;
      return true;
    default:
      return false;
  }
}

/// The switch that an action flips; nullptr: none.
bool* shown_flag(ViewState& state, Action action) {
  switch (action) {
    case Action::visited:
      return &state.shown.visited;
    case Action::pruned:
      return &state.shown.pruned;
    case Action::found:
      return &state.shown.found;
    case Action::pruning:
      return &state.prune;
    case Action::contact_triangles:
      return &state.shown.contact_triangles;
    case Action::crossing_segments:
      return &state.shown.crossing_segments;
    case Action::gap:
      return &state.shown.gap;
    case Action::contact_lines:
      return &state.shown.contact_lines;
    case Action::contact_parts:
      return &state.shown.contact_parts;
    case Action::contacts_on_top:
      return &state.shown.contacts_on_top;
    case Action::edges:
      return &state.shown.edges;
    case Action::movers:
      return &state.shown.movers;
    case Action::gizmo:
      return &state.shown.gizmo;
    default:
      return nullptr;
  }
}

/// How an action moves the object; a default one where it does not.
ObjectMove move_of(Action action) {
  constexpr double kFine = 0.1;
  switch (action) {
    case Action::object_right:
      return {.right = 1};
    case Action::object_left:
      return {.right = -1};
    case Action::object_forward:
      return {.forward = 1};
    case Action::object_backward:
      return {.forward = -1};
    case Action::object_up:
      return {.up = 1};
    case Action::object_down:
      return {.up = -1};
    case Action::object_right_fine:
      return {.right = 1, .scale = kFine};
    case Action::object_left_fine:
      return {.right = -1, .scale = kFine};
    case Action::object_forward_fine:
      return {.forward = 1, .scale = kFine};
    case Action::object_backward_fine:
      return {.forward = -1, .scale = kFine};
    case Action::object_up_fine:
      return {.up = 1, .scale = kFine};
    case Action::object_down_fine:
      return {.up = -1, .scale = kFine};
    case Action::object_turn_left:
      return {.turn = 1};
    case Action::object_turn_right:
      return {.turn = -1};
    default:
      return {};
  }
}

}  // namespace

std::span<const ActionRow> actions() {
  return kActions;
}

std::optional<Action> action_of(const KeyPress& press) {
  if (press.key == Key::none) {
    return std::nullopt;
  }
  const auto* const row = std::find_if(kActions.begin(), kActions.end(), [&](const ActionRow& r) {
    return r.press == press || r.other == press;
  });
  return row == kActions.end() ? std::nullopt : std::optional(row->action);
}

std::string keys_of(Action action) {
  const ActionRow& row = kActions[static_cast<std::size_t>(action)];
  std::string text = name(row.press);
  if (row.other.key != Key::none) {
    text += ", " + name(row.other);
  }
  return text;
}

bool repeats(Action action) {
  return action == Action::step || action == Action::step_back || action == Action::level_down ||
         action == Action::level_up || action == Action::learn_next ||
         action == Action::learn_previous ||
         (action >= Action::object_right && action <= Action::object_turn_right);
}

bool is_fine(Action action) {
  return action >= Action::object_right_fine && action <= Action::object_down_fine;
}

void apply(ViewState& state, Action action) {
  if (apply_general(state, action) || apply_camera(state, action) || apply_list(state, action) ||
      apply_tree(state, action)) {
    return;
  }
  if (bool* const flag = shown_flag(state, action)) {
    flip(*flag);
    return;
  }
  if (!state.limits.has_object) {
    return;
  }
  if (action == Action::object_home) {
    state.requests.object_home = true;
  } else {
    state.requests.move = move_of(action);
  }
}

void set_orientation_test(ViewState& state, std::optional<std::size_t> row) {
  state.orientation_test = row;
  state.paused = false;
  state.frame = 0;
  state.requests.fit_all = row.has_value();
}

}  // namespace soms::view
