/// \file
/// The viewer without a window: events in, state, camera and draw list out.
#pragma once

#include "soms/base/error.h"
#include "soms/base/pose.h"

#include "apps/view/control/camera_moves.h"
#include "apps/view/control/gizmo.h"
#include "apps/view/control/input_event.h"
#include "apps/view/control/playback.h"
#include "apps/view/control/subject.h"
#include "apps/view/control/view_state.h"
#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {

/// What the panels keep for themselves in this frame.
struct Captured {
  bool mouse = false;
  bool keys = false;
};

/// One run of the viewer. In each frame: `push` events, `handle` them, `tick`, draw the panels
/// (they change `state()`), draw `picture()` from `camera()`.
class Session {
 public:
  /// Looks at all of the subject. The subject must outlive the session.
  Session(Subject& subject, Size window);

  /// `point` is how many units of the window, those of the cursor, a point has on its display.
  void resize(Size window, double point = 1);

  /// Panels cover parts of the window: the camera fits things beside them. What is picked gets a
  /// panel at the right, which covers so much.
  void set_covered(const Covered& covered, double right_of_picked = 0);

  [[nodiscard]] const Covered& covered() const { return covered_; }

  /// From here on the first event that is found is gone to once, unless the user does anything
  /// before.
  void await_first_event() { awaits_first_ = true; }

  /// Keeps an event for `handle`.
  void push(InputEvent event) { events_.push_back(std::move(event)); }

  /// Does what the events say. What the panels captured is not for us, but a drag goes on over
  /// them.
  void handle(const Captured& captured);

  /// Fulfils requests, lets time pass, moves the camera. Errors become `message`.
  void tick(double seconds);

  [[nodiscard]] ViewState& state() { return state_; }

  [[nodiscard]] const ViewState& state() const { return state_; }

  [[nodiscard]] const Camera& camera() const { return camera_; }

  [[nodiscard]] const Facts& facts() const { return facts_; }

  [[nodiscard]] const EventList& events() const { return subject_.events(); }

  [[nodiscard]] const std::optional<PickedFacts>& picked() const { return picked_; }

  [[nodiscard]] Size window() const { return window_; }

  /// The last error in words; empty: none. It goes with the next action that works.
  [[nodiscard]] const std::string& message() const { return message_; }

  /// Starts an orientation test in one of its frames, seen whole at once: nothing glides there.
  /// \pre The frame is one of the test's. \errors As `Subject::choose`.
  void start_test(std::size_t row, std::uint64_t frame);

  void set_message(std::string text) { message_ = std::move(text); }

  void set_camera(const Camera& camera) { camera_ = camera; }

  /// The picture with the gizmo. Made again only after a change.
  [[nodiscard]] const DrawList& picture();

  /// The picture without the gizmo, for paper.
  [[nodiscard]] const DrawList& bare_picture();

  /// Goes up whenever `picture` made the list again; the gizmo alone does not count.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  /// The gizmo, where it is shown.
  [[nodiscard]] std::optional<Gizmo> gizmo() const;

  /// The handle that is dragged, or under the cursor.
  [[nodiscard]] std::optional<Handle> handle_in_use() const;

  /// True while something moves by itself: frames are wanted without an event.
  [[nodiscard]] bool animating() const;

  /// True while the picture changes from frame to frame, also by the hand.
  [[nodiscard]] bool moving() const;

 private:
  struct Press {
    MouseButton button = MouseButton::left;
    PixelPoint from;  ///< where it began
    PixelPoint last;  ///< where the camera was last moved for it
    CameraDrag kind = CameraDrag::turn;
    bool dragging = false;  ///< moved farther than a click's tremble
  };

  void take(const KeyDown& event);
  void take_in_files(const KeyPress& press);
  void take(const KeyUp& event);
  void take(const MouseDown& event);
  void take(const MouseUp& event);
  void take(const Wheel& event);
  void release_all();
  void set_fly_key(Key key, bool down);
  void drag_to(PixelPoint at);
  /// What the subject has at a pixel; nothing, and a message, where it cannot say.
  [[nodiscard]] std::optional<PickedFacts> seen_at(PixelPoint at);
  void pick(PixelPoint at);
  void set_pivot(PixelPoint at);

  void do_requests();
  void do_camera_requests();
  void do_event_requests();
  void go_to_event(std::size_t row, bool with_panel);
  void go_to_first_event();
  void step_events();
  void renew_picked();
  void open_files(const std::vector<std::string>& paths);
  [[nodiscard]] bool searching() const;
  [[nodiscard]] bool changing() const;
  void do_time_requests();
  void move_object(const ObjectMove& move);
  void refresh();
  void tell_choice();
  void run(double seconds);

  void go(const Camera& goal) { flight_ = CameraFlight(camera_, goal); }

  [[nodiscard]] Camera seen_whole(Side side) const;
  [[nodiscard]] Camera fit(const Box& box) const;
  void frame_again();

  void start_following();
  void follow(const std::optional<Pose>& before);
  /// Runs a task whose error becomes the message; true if it had none.
  template <typename Task>
  bool attempted(Task&& task);

  /// As `attempted`, of a task after which the picture is another one. Passing time is no action:
  /// it clears no message.
  template <typename Task>
  bool guarded(Task&& task, bool clears = true);

  Subject& subject_;
  Size window_;
  double point_ = 1;
  Covered covered_;
  double right_of_picked_ = 0;
  Camera first_;  ///< that the viewer chose: it follows the window until the user moves it
  ViewState state_;
  Camera camera_;
  Facts facts_;
  std::optional<PickedFacts> picked_;
  std::pair<std::uint64_t, std::optional<Pose>> picked_at_;  ///< frame and object then
  bool awaits_first_ = false;  ///< the first event is still to be shown
  std::string message_;
  std::string first_message_;  ///< of the first event: it goes with the frame
  std::vector<InputEvent> events_;
  std::optional<Press> press_;
  std::optional<GizmoDrag> drag_;
  std::optional<CameraFlight> flight_;
  std::optional<PixelPoint> cursor_;  ///< nothing while over a panel
  std::optional<PixelPoint> click_;   ///< the press before, for double clicks
  double click_time_ = 0;
  FlyKeys fly_;
  Playback playback_;
  CameraMode mode_before_ = CameraMode::orbit;
  std::uint64_t followed_before_ = 0;
  std::filesystem::path last_folder_ = ".";
  Choice choice_;        ///< that the subject was given
  bool changed_ = true;  ///< the list is to be rebuilt
  DrawList list_;
  std::uint64_t version_ = 0;
  std::size_t scene_lines_ = 0;  ///< of the list; what follows is the gizmo's
  std::size_t scene_marks_ = 0;
};

template <typename Task>
bool Session::attempted(Task&& task) {
  try {
    task();
  } catch (const Error& error) {
    message_ = error.what();
    return false;
  }
  return true;
}

template <typename Task>
bool Session::guarded(Task&& task, bool clears) {
  changed_ = true;
  if (!attempted(task)) {
    return false;
  }
  if (clears) {
    message_.clear();
  }
  return true;
}

}  // namespace soms::view
