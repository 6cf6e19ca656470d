/// \file
/// What the controls need to know of the thing shown, and what they may ask of it.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/query/answer.h"

#include "apps/view/control/view_state.h"
#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

/// Something that was clicked on, in words and numbers.
struct PickedFacts {
  std::string title;                                         ///< "triangle 4711 of city.ply"
  std::vector<std::pair<std::string, std::string>> numbers;  ///< label and value, in order
  std::vector<std::string> why;                              ///< sentences: why it was decided so
  Vec3 point;                                                ///< where it was hit
  Box bounds;                                                ///< of what was picked, in the world

  [[nodiscard]] bool operator==(const PickedFacts&) const = default;
};

/// The gap of the object in words and numbers.
struct GapFacts {
  std::string length;  ///< as it is written beside its line; empty: the gap is not known
  std::vector<std::pair<std::string, std::string>> numbers;  ///< label and value, in order
  Box surroundings;  ///< what is worth seeing of it, if it is known

  [[nodiscard]] bool operator==(const GapFacts&) const = default;
};

/// Two bodies touch over a stretch of time.
struct ContactEvent {
  std::string title;  ///< "car 12 touches town"
  std::uint64_t begin = 0;
  std::uint64_t end = 0;         ///< the last frame in which they touch
  std::uint64_t most_pairs = 0;  ///< pairs of triangles, in the frame that has the most
  std::uint64_t most_frame = 0;  ///< the first such frame
  double after = 0;  ///< of a passage: the part of the way from frame `begin` to the next; else 0

  [[nodiscard]] bool operator==(const ContactEvent&) const = default;
};

/// The contacts of the first frames, as they would be without the hand, by their begin.
struct EventList {
  std::vector<ContactEvent> rows;  ///< grows at its end, until the search starts over
  std::uint64_t edition = 0;       ///< another one when the search started over
  std::uint64_t searched = 0;      ///< frames
  std::uint64_t frames = 0;        ///< that are to be searched

  [[nodiscard]] bool done() const { return searched >= frames; }
};

/// What to look at, and from where.
struct Sight {
  PickedFacts facts;
  Camera camera;
};

/// A tree as rows of bars: the root above, each node as wide as its share of the triangles.
struct TreeBars {
  enum class Look : std::uint8_t { untouched, pruned, visited, found, now };

  struct Bar {
    float left = 0;  ///< 0 to 1
    float right = 1;
    std::uint16_t level = 0;
    Look look = Look::untouched;
  };

  std::string name;  ///< of the body
  Color now;         ///< of its boxes in the scene
  std::vector<Bar> bars;
  std::uint16_t levels = 1;
};

/// One test of a traversal, in words.
struct LearnFacts {
  std::uint64_t tests = 0;             ///< that can be stepped through
  std::uint64_t test = 0;              ///< that is shown, from 0
  std::string title;                   ///< how the traversal goes
  std::vector<std::string> sentences;  ///< what this test is, and what follows from it
  TreeBars a;
  TreeBars b;
};

/// Numbers for the panels: of the last step, and of the thing as a whole.
struct Facts {
  std::string name;  ///< of what is shown, for the title
  std::string note;  ///< one line that the user should know; empty: none
  std::uint64_t triangles = 0;
  std::uint64_t movers = 0;
  std::uint64_t frame = 0;     ///< that is shown
  std::uint64_t contacts = 0;  ///< pairs of triangles that touch
  std::uint64_t bodies = 0;    ///< movers that touch something
  std::string clearance;       ///< within which gaps are counted, with its unit; empty: none are
  std::uint64_t gaps = 0;      ///< pairs of bodies within it that do not touch
  std::string least_gap;       ///< length of the least, with its unit; empty where there is none
  bool traversed = false;      ///< the next three were counted
  bool trace_cut = false;      ///< and are of a part of the traversal: there is more
  std::uint64_t visited = 0;   ///< boxes, or pairs of boxes, of the last traversal
  std::uint64_t pruned = 0;
  std::uint64_t found = 0;
  Cost cost;                ///< of the traversal chosen; of Traversal::fast that of the last step
  double collision_ms = 0;  ///< time that this took, without drawing
  std::optional<std::uint64_t> entered;  ///< pairs of nodes; nothing of Traversal::fast
  bool cost_cut = false;                 ///< time ran out: costs are of a part of the traversal
  /// What found no room in the last picture, a line each: "2,000 of 12,345 contacts".
  std::vector<std::string> left_out;
  ViewLimits limits;
  std::optional<std::size_t> orientation_test;  ///< that runs; moving the object by hand ends it
  Box bounds;                                   ///< of all that is shown
  Box framed;                                   ///< what the first picture frames; empty: all
  std::optional<GapFacts> gap;                  ///< where it is shown and there is one
  std::optional<LearnFacts> learn;              ///< where it is requested and there is a pair
  std::optional<Pose> object;                   ///< of what is moved by hand
  Box object_bounds;                            ///< in the world
  std::optional<Pose> followed;                 ///< of the mover that the camera follows
  Box followed_bounds;                          ///< in the world
};

/// The thing shown. Kept by one thread.
class Subject {
 public:
  virtual ~Subject() = default;

  /// Brings rule, traversal, pruning and test of orientation to what the state says, and counts
  /// contacts again where that matters. May take as long as a build.
  /// \errors  As the library's builds and queries.
  virtual void choose(const ViewState& state) = 0;

  /// Numbers as of now.
  [[nodiscard]] virtual Facts facts(const ViewState& state) const = 0;

  /// Goes on by frames; backward (a negative number) only where `ViewLimits::can_seek`.
  virtual void advance(int frames) = 0;

  /// To a frame. \pre ViewLimits::can_seek.
  virtual void seek(std::uint64_t frame) = 0;

  /// Back to the first frame.
  virtual void restart() = 0;

  /// Puts the object somewhere and counts its contacts. \pre ViewLimits::has_object.
  virtual void place_object(const Pose& pose) = 0;

  /// Puts the object back to where it was at first. \pre ViewLimits::has_object.
  virtual void object_home() = 0;

  /// What is seen first along a ray: a contact, or a triangle of any body.
  [[nodiscard]] virtual std::optional<PickedFacts> pick(const Ray& ray) = 0;

  /// Draws what the last `pick` gave brighter. A mover becomes the object that is moved by hand.
  virtual void select() = 0;

  /// What is drawn brighter, as of now; nothing once it is a contact no more.
  [[nodiscard]] virtual std::optional<PickedFacts> selection() const = 0;

  /// Draws nothing brighter any more.
  virtual void deselect() = 0;

  /// What touches what in the frames searched so far.
  [[nodiscard]] virtual const EventList& events() const = 0;

  /// Searches frames for contacts for a moment. \errors As the library's queries.
  virtual void search_events() = 0;

  /// Goes to the frame in which an event has most pairs of triangles, and chooses one of them. What
  /// is farther off is pale while the choice lasts. `fit` places the camera.
  /// \pre `row` is in `events`. \errors As `seek`.
  virtual Sight show_event(std::size_t row, const FitCamera& fit) = 0;

  /// Shows another model. \errors As `read_mesh`; what was shown before stays then.
  virtual void open(const std::string& path) = 0;

  /// The picture without the gizmo.
  [[nodiscard]] virtual DrawList draw_list(const ViewState& state) = 0;
};

}  // namespace soms::view
