/// \file
/// All that a user chose: what is shown, how it runs, what was requested and not yet done.
#pragma once

#include "soms/thesis/traversal_options.h"
#include "soms/tree/build_options.h"

#include "apps/view/control/file_list.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace soms::view {

/// Whose tree is shown as boxes.
enum class TreeOf { city, mover };

/// How the mouse and the keys move the camera.
enum class CameraMode {
  orbit,   ///< turns about a pivot
  fly,     ///< looks around from where it is; W, A, S, D move it
  follow,  ///< keeps its place relative to a mover
};

/// Direction that the camera is to look from.
enum class Side { front, right, top, corner };

/// What is drawn beside the city and its movers.
struct Shown {
  bool tree_boxes = false;        ///< boxes of one level of a tree
  bool visited = false;           ///< boxes that the last traversal tested and entered
  bool pruned = false;            ///< boxes that it tested and left
  bool found = false;             ///< boxes of the leaves whose triangles it decided
  bool contact_triangles = true;  ///< triangles that touch, in red
  bool crossing_segments = true;  ///< where they cross
  bool gap = true;                ///< nearest points of the object, if it does not touch
  bool contact_lines = false;     ///< from each body to its contacts
  bool contact_parts = false;     ///< the whole parts that touch, in a paler red
  bool contacts_on_top = false;   ///< contacts seen through everything
  bool edges = false;             ///< edges of all triangles
  bool movers = true;
  bool gizmo = true;  ///< the handles of the object that is moved by hand

  [[nodiscard]] bool operator==(const Shown&) const = default;
};

/// What the thing shown allows. Filled from it before each frame.
struct ViewLimits {
  int city_levels = 1;       ///< levels of the city's tree
  int mover_levels = 1;      ///< levels of the object's tree
  std::uint64_t frames = 0;  ///< frames that there are; 0: without end
  std::uint64_t movers = 0;  ///< movers that can be followed
  bool moves = false;        ///< time changes something: there is something to run
  bool can_seek = false;     ///< a recording or an orientation test: any frame at once
  bool has_object = false;   ///< something can be moved by hand
  double object_size = 1;    ///< greatest side of its box
  double scene_size = 1;     ///< greatest side of the scene's box
};

/// Shifts of the object, as multiples of the keyboard's step along the camera's axes (right,
/// forward, up) and a turn about z, that wait to be done.
struct ObjectMove {
  int right = 0;
  int forward = 0;
  int up = 0;
  int turn = 0;
  double scale = 1;  ///< of the step: finer with Shift

  [[nodiscard]] bool operator==(const ObjectMove&) const = default;
};

/// Wishes that last until the loop has done them.
struct Requests {
  bool quit = false;
  bool screenshot = false;         ///< the picture alone
  bool screenshot_panels = false;  ///< with the panels over it
  bool fullscreen = false;         ///< change to full screen or back
  bool restart = false;            ///< the simulation from its first frame
  bool fit_all = false;            ///< camera to where all is seen
  bool fit_gap = false;            ///< camera to where the object is nearest to something
  bool fit_object = false;         ///< camera to the object or to what was picked
  bool object_home = false;        ///< the object back to where it was at first
  bool deselect = false;
  bool list_files = false;           ///< show a folder to open a model from
  bool open_chosen = false;          ///< open what is chosen in it
  int event_step = 0;                ///< to the next event, 1, or the one before, -1
  std::optional<std::size_t> event;  ///< to this row of the events
  std::optional<Side> look_from;     ///< camera to one side of the scene
  std::optional<std::uint64_t> seek;
  int steps = 0;  ///< frames to go on (or back where that can be) while paused
  ObjectMove move;
  std::vector<std::string> open;  ///< model files to load, in turn
};

/// State of the viewer: plain data, changed by `apply` and the panels.
struct ViewState {
  bool paused = true;
  double speed = 1;         ///< frames for each frame of real time
  std::uint64_t frame = 0;  ///< of the simulation, the test or the recording
  Rule rule = Rule::soms;
  Traversal traversal = Traversal::fast;
  bool prune = true;                  ///< false only to show what pruning saves (thesis, fig. 4.35)
  BuildOptions tree;                  ///< all but the rule; what that does not use has no effect
  Descent descent = Descent::larger;  ///< of E-Node
  TreeOf tree_of = TreeOf::city;
  int level = 1;  ///< of the boxes shown, counted from 1 at the root
  Shown shown;
  CameraMode camera = CameraMode::orbit;
  std::uint64_t followed = 0;                   ///< the mover that `CameraMode::follow` keeps
  std::optional<std::size_t> orientation_test;  ///< row of `orientation_tests`; unset: none runs
  bool help = false;
  std::optional<FileList> files;     ///< the folder that is shown to open a model from
  bool events = false;               ///< the list of events is shown, where panels are
  std::optional<std::size_t> event;  ///< the event that was last gone to
  bool at_event = false;             ///< it is what is picked
  bool learn = false;                ///< the traversal is shown test by test
  std::uint64_t learn_step = 0;      ///< the test that is shown
  bool panels = true;
  bool selected = false;  ///< something is picked
  ViewLimits limits;
  Requests requests;
};

/// What of the state makes the picture another one, or the trees.
struct Choice {
  Shown shown;
  Rule rule = Rule::fast;
  Traversal traversal = Traversal::fast;
  bool prune = true;
  BuildOptions tree;
  Descent descent = Descent::larger;
  TreeOf tree_of = TreeOf::city;
  int level = 1;
  std::optional<std::size_t> orientation_test;
  bool learn = false;
  std::uint64_t learn_step = 0;

  [[nodiscard]] bool operator==(const Choice&) const = default;
};

[[nodiscard]] Choice choice(const ViewState& state);

/// Begins with these trees and this traversal. Where that has no descent, E-Node's stays.
void begin_with(ViewState& state, const BuildOptions& build, const TraversalOptions& traversal);

/// The descents that a traversal takes: all of E-Node, upward ones of the front, else none.
[[nodiscard]] std::vector<Descent> descents_of(Traversal traversal);

/// The descent that the traversal of a state has: the chosen one, or larger where it does not take
/// that.
[[nodiscard]] Descent descent_of(const ViewState& state);

/// Brings tree, traversal and pruning back to a choice of before.
void take_back(ViewState& state, const Choice& before);

/// E-Node in place of Traversal::fast, which has no boxes to show, if the state shows boxes of a
/// traversal and the choice of before showed none.
void choose_boxes(ViewState& state, const Choice& before);

inline constexpr double kSlowest = 1.0 / 16;
inline constexpr double kFastest = 16;

/// Levels of the tree that is shown; at least 1.
[[nodiscard]] int levels(const ViewState& state);

/// Brings level, frame and the mover followed into what the limits allow.
void clamp(ViewState& state);

[[nodiscard]] const char* name(CameraMode mode);
[[nodiscard]] const char* name(TreeOf tree);

}  // namespace soms::view
