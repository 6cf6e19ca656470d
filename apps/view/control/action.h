/// \file
/// What a key can do: one table of action, key, group and help text, and what each does to the
/// state. The help page, the panels' hints and the documentation come from it.
#pragma once

#include "apps/view/control/keys.h"
#include "apps/view/control/view_state.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace soms::view {

enum class Action {
  help,
  back,
  open,
  quit,
  panels,
  fullscreen,
  screenshot,
  screenshot_panels,
  pause,
  step,
  step_back,
  faster,
  slower,
  first_frame,
  last_frame,
  reset_camera,
  view_front,
  view_right,
  view_top,
  view_corner,
  camera_mode,
  next_mover,
  previous_mover,
  focus,
  focus_gap,
  events,
  event_next,
  event_previous,
  rule_next,
  rule_previous,
  traversal_next,
  traversal_previous,
  descent_next,
  descent_previous,
  thesis,
  orientation_next,
  orientation_previous,
  tree_boxes,
  tree_of,
  level_down,
  level_up,
  learn,
  learn_next,
  learn_previous,
  visited,
  pruned,
  found,
  pruning,
  contact_triangles,
  crossing_segments,
  gap,
  contact_lines,
  contact_parts,
  contacts_on_top,
  edges,
  movers,
  gizmo,
  object_right,
  object_left,
  object_forward,
  object_backward,
  object_up,
  object_down,
  object_right_fine,
  object_left_fine,
  object_forward_fine,
  object_backward_fine,
  object_up_fine,
  object_down_fine,
  object_turn_left,
  object_turn_right,
  object_home,
};

/// A row of the table.
struct ActionRow {
  Action action;
  KeyPress press;
  KeyPress other;          ///< a second key for the same; Key::none where there is none
  std::string_view group;  ///< heading in the help
  std::string_view help;   ///< what it does
};

/// All actions in the order of `Action`; no key stands twice.
[[nodiscard]] std::span<const ActionRow> actions();

/// The action of a key, if it has one.
[[nodiscard]] std::optional<Action> action_of(const KeyPress& press);

/// The keys of an action as text: "H, F1".
[[nodiscard]] std::string keys_of(Action action);

/// True if holding the key does it again and again.
[[nodiscard]] bool repeats(Action action);

/// True for a move by a tenth of a step: the key of the whole step with Shift.
[[nodiscard]] bool is_fine(Action action);

/// Does an action. What the state alone cannot do (the window, the camera, the simulation) is left
/// in `requests`.
void apply(ViewState& state, Action action);

/// Starts a test of orientation, a row of `orientation_tests`, from its first frame, running and in
/// view; without a row it leaves the one that runs.
void set_orientation_test(ViewState& state, std::optional<std::size_t> row);

}  // namespace soms::view
