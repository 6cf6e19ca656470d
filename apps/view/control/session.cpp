#include "apps/view/control/session.h"

#include "soms/base/error.h"

#include "apps/view/control/action.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <variant>

namespace soms::view {

namespace {

constexpr double kTremble = 4;         ///< points within which a press is a click
constexpr double kDoubleClick = 0.35;  ///< seconds
constexpr double kHandleSlack = 7;     ///< points
constexpr double kGizmoPoints = 40;    ///< length of an arrow
constexpr double kMessagePoints = 30;  ///< height of the line of messages
constexpr double kStepOfObject = 0.1;  ///< keyboard step in sizes of the object
constexpr double kTurnOfObject = std::numbers::pi / 36;
constexpr double kLongestTick = 0.25;  ///< a longer one was a rest: nothing leaps after it

double apart(PixelPoint a, PixelPoint b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// The direction among +x, -x, +y, -y that is nearest to a vector.
Vec3 level_axis(const Vec3& v) {
  if (std::abs(v.x) >= std::abs(v.y)) {
    return {v.x < 0 ? -1.0 : 1.0, 0, 0};
  }
  return {0, v.y < 0 ? -1.0 : 1.0, 0};
}

CameraDrag kind_of(const MouseDown& event) {
  switch (event.button) {
    case MouseButton::left:
      return event.shift || event.control ? CameraDrag::pan : CameraDrag::turn;
    case MouseButton::middle:
      return CameraDrag::pan;
    case MouseButton::right:
      return CameraDrag::dolly;
  }
  return CameraDrag::turn;
}

/// True of what a user does on purpose.
bool is_act(const InputEvent& event) {
  return std::holds_alternative<KeyDown>(event) || std::holds_alternative<MouseDown>(event) ||
         std::holds_alternative<Wheel>(event) || std::holds_alternative<FileDropped>(event);
}

}  // namespace

Session::Session(Subject& subject, Size window) : subject_(subject), window_(window) {
  choice_ = choice(state_);
  guarded([&] { subject_.choose(state_); });
  refresh();
  first_ = camera_;
  frame_again();
}

void Session::set_covered(const Covered& covered, double right_of_picked) {
  right_of_picked_ = right_of_picked;
  if (covered != covered_) {
    covered_ = covered;
    frame_again();
  }
}

void Session::resize(Size window, double point) {
  point_ = point;
  if (window != window_) {
    window_ = window;
    frame_again();
  }
}

void Session::refresh() {
  facts_ = subject_.facts(state_);
  state_.limits = facts_.limits;
  state_.frame = facts_.frame;
  state_.orientation_test = facts_.orientation_test;
  choice_.orientation_test = facts_.orientation_test;
  if (facts_.learn) {
    state_.learn_step = choice_.learn_step = facts_.learn->test;
  }
  clamp(state_);
}

void Session::handle(const Captured& captured) {
  std::vector<InputEvent> events;
  events.swap(events_);
  std::optional<PixelPoint> moved;
  for (const InputEvent& event : events) {
    awaits_first_ = awaits_first_ && !is_act(event);
    // Only the last of several moves counts: each would ask for all contacts again.
    if (const auto* const move = std::get_if<MouseMove>(&event)) {
      moved = move->at;
      continue;
    }
    if (moved) {
      drag_to(*moved);
      moved.reset();
    }
    std::visit(
        [&](const auto& e) {
          using Event = std::decay_t<decltype(e)>;
          if constexpr (std::is_same_v<Event, KeyDown>) {
            if (state_.files && e.press.key < Key::f1 && !captured.keys) {
              take_in_files(e.press);
            } else if (!captured.keys) {
              take(e);
            }
          } else if constexpr (std::is_same_v<Event, MouseDown> || std::is_same_v<Event, Wheel>) {
            if (!captured.mouse) {
              take(e);
            }
          } else if constexpr (std::is_same_v<Event, FocusLost>) {
            release_all();
          } else if constexpr (std::is_same_v<Event, FileDropped>) {
            state_.requests.open.push_back(e.path);
          } else if constexpr (!std::is_same_v<Event, MouseMove>) {
            take(e);
          }
        },
        event);
  }
  if (moved) {
    drag_to(*moved);
    cursor_ = moved;
  }
  if (captured.mouse) {
    cursor_.reset();
  }
}

void Session::take(const KeyDown& event) {
  if (state_.camera == CameraMode::fly && !event.press.control) {
    set_fly_key(event.press.key, true);
    fly_.fast = event.press.shift;
  }
  if (event.press.key == Key::escape && drag_) {
    const Pose start = drag_->start();
    drag_.reset();
    guarded([&] { subject_.place_object(start); });
    return;
  }
  const auto action = action_of(event.press);
  if (!action || (event.repeat && !repeats(*action))) {
    return;
  }
  apply(state_, *action);
  // Held keys come faster than frames: each counts.
  if (state_.requests.move != ObjectMove{}) {
    move_object(state_.requests.move);
    state_.requests.move = {};
  }
}

void Session::take(const KeyUp& event) {
  set_fly_key(event.key, false);
}

void Session::set_fly_key(Key key, bool down) {
  if (key == key_of('W')) {
    fly_.forward = down;
  } else if (key == key_of('S')) {
    fly_.backward = down;
  } else if (key == key_of('A')) {
    fly_.left = down;
  } else if (key == key_of('D')) {
    fly_.right = down;
  }
}

void Session::release_all() {
  fly_ = {};
  press_.reset();
  drag_.reset();
}

void Session::take(const MouseDown& event) {
  cursor_ = event.at;
  if (press_ || drag_) {
    return;  // a second button of a drag
  }
  if (event.button == MouseButton::left && !event.shift && !event.control) {
    if (const auto handle = handle_in_use()) {
      drag_.emplace(*gizmo(), *handle, *facts_.object, ray_through(camera_, window_, event.at));
      return;
    }
    const bool twice = click_ && event.time - click_time_ <= kDoubleClick &&
                       apart(*click_, event.at) <= kTremble * point_;
    click_ = twice ? std::nullopt : std::optional(event.at);
    click_time_ = event.time;
    if (twice) {
      set_pivot(event.at);
      return;
    }
  }
  flight_.reset();
  press_ = Press{event.button, event.at, event.at, kind_of(event)};
}

void Session::take(const MouseUp& event) {
  drag_to(event.at);
  if (drag_ && event.button == MouseButton::left) {
    drag_.reset();
  }
  if (press_ && press_->button == event.button) {
    const bool click = !press_->dragging && event.button == MouseButton::left;
    press_.reset();
    if (click) {
      pick(event.at);
    }
  }
}

void Session::take(const Wheel& event) {
  flight_.reset();
  const auto under = seen_at(event.at);
  camera_ = wheeled(camera_, state_.camera, event.notches, event.at, window_,
                    under ? std::optional(under->point) : std::nullopt,
                    zoom_ends(state_.limits.scene_size, camera_.target));
}

void Session::drag_to(PixelPoint at) {
  if (drag_) {
    const Pose pose = drag_->dragged(ray_through(camera_, window_, at));
    if (facts_.object != pose) {
      guarded([&] { subject_.place_object(pose); });
      facts_.object = pose;
    }
    return;
  }
  if (!press_) {
    return;
  }
  if (!press_->dragging && apart(at, press_->from) <= kTremble * point_) {
    return;
  }
  press_->dragging = true;
  camera_ =
      dragged(camera_, state_.camera, press_->kind, at.x - press_->last.x, at.y - press_->last.y,
              window_, zoom_ends(state_.limits.scene_size, camera_.target));
  press_->last = at;
}

std::optional<PickedFacts> Session::seen_at(PixelPoint at) {
  try {
    return subject_.pick(ray_through(camera_, window_, at));
  } catch (const Error& error) {
    message_ = error.what();
    return std::nullopt;
  }
}

void Session::pick(PixelPoint at) {
  picked_ = seen_at(at);
  picked_at_ = {facts_.frame, facts_.object};
  state_.selected = picked_.has_value();
  state_.at_event = false;
  if (picked_) {
    subject_.select();
  } else {
    subject_.deselect();
  }
  changed_ = true;
}

void Session::set_pivot(PixelPoint at) {
  if (const auto under = seen_at(at)) {
    go(pivoted(camera_, under->point));
  }
}

void Session::tick(double seconds) {
  const double passed = std::min(seconds, kLongestTick);
  const auto before = facts_.followed;
  do_time_requests();
  do_requests();
  do_event_requests();
  tell_choice();
  run(passed);
  refresh();
  renew_picked();
  follow(before);
  do_camera_requests();
  if (fly_.any() && state_.camera == CameraMode::fly) {
    camera_ = view::flown(camera_, fly_, passed, state_.limits.scene_size);
  }
  if (flight_) {
    camera_ = flight_->after(passed);
    if (flight_->over()) {
      flight_.reset();
    }
  }
}

void Session::run(double seconds) {
  if (!state_.paused && !state_.limits.moves) {
    state_.paused = true;
    message_ = "nothing moves by itself here: drag a handle, or start an orientation test";
  }
  if (state_.paused) {
    playback_.reset();
  } else if (const int frames = playback_.due(seconds, state_.speed); frames > 0) {
    guarded([&] { subject_.advance(frames); }, false);
  }
}

void Session::tell_choice() {
  if (choice_ == choice(state_)) {
    return;
  }
  choose_boxes(state_, choice_);
  if (!guarded([&] { subject_.choose(state_); })) {
    // Kept, it would be refused with every picture to come, and the one of before would stay.
    take_back(state_, choice_);
  }
  choice_ = choice(state_);
  refresh();  // a test that began or ended changes what moves
}

void Session::do_time_requests() {
  Requests& wishes = state_.requests;
  if (wishes.restart) {
    wishes.restart = false;
    guarded([&] { subject_.restart(); });
  }
  if (wishes.seek) {
    const std::uint64_t frame = *wishes.seek;
    wishes.seek.reset();
    guarded([&] { subject_.seek(frame); });
  }
  if (wishes.steps != 0) {
    const int steps = wishes.steps;
    wishes.steps = 0;
    guarded([&] { subject_.advance(steps); });
  }
}

void Session::do_requests() {
  Requests& wishes = state_.requests;
  if (wishes.deselect) {
    wishes.deselect = false;
    picked_.reset();
    state_.selected = false;
    state_.at_event = false;
    subject_.deselect();
    changed_ = true;
  }
  if (wishes.move != ObjectMove{}) {
    move_object(wishes.move);
    wishes.move = {};
  }
  if (wishes.object_home) {
    wishes.object_home = false;
    guarded([&] { subject_.object_home(); });
  }
  if (std::exchange(wishes.list_files, false)) {
    state_.files.emplace(last_folder_);
  }
  if (std::exchange(wishes.open_chosen, false) && state_.files) {
    if (const auto path = state_.files->open()) {
      last_folder_ = state_.files->folder();
      state_.files.reset();
      wishes.open.push_back(path->string());
    }
  }
  if (!wishes.open.empty()) {
    open_files(std::exchange(wishes.open, {}));
  }
}

void Session::move_object(const ObjectMove& move) {
  if (!facts_.object || drag_) {
    return;
  }
  const CameraFrame axes = frame(camera_);
  // Seen from above, "away" is where the picture's upper edge lies.
  const Vec3 ahead = level_axis(std::abs(axes.forward.z) > 0.8 ? axes.up : axes.forward);
  const Vec3 right{ahead.y, -ahead.x, 0};
  const double step = kStepOfObject * state_.limits.object_size * move.scale;
  const Vec3 offset =
      right * (step * move.right) + ahead * (step * move.forward) + Vec3{0, 0, step * move.up};
  Pose pose = shifted(*facts_.object, offset);
  if (move.turn != 0) {
    pose = turned_about(pose, facts_.object_bounds.center(), kTurnOfObject * move.turn);
  }
  guarded([&] { subject_.place_object(pose); });
  facts_ = subject_.facts(state_);
}

std::optional<Gizmo> Session::gizmo() const {
  if (!state_.shown.gizmo || !facts_.object || facts_.object_bounds.empty()) {
    return std::nullopt;
  }
  return gizmo_at(camera_, window_, facts_.object_bounds.center(), kGizmoPoints * point_);
}

std::optional<Handle> Session::handle_in_use() const {
  if (drag_) {
    return drag_->handle();
  }
  const auto handles = gizmo();
  if (!handles || !cursor_ || press_) {
    return std::nullopt;
  }
  return handle_at(*handles, camera_, window_, *cursor_, kHandleSlack * point_);
}

const DrawList& Session::picture() {
  (void)bare_picture();
  list_.captions.covered = covered_.left / std::max(window_.width, 1);
  list_.captions.covered_right = covered_.right / std::max(window_.width, 1);
  list_.captions.covered_below = kMessagePoints * point_ / std::max(window_.height, 1);
  if (const auto handles = gizmo()) {
    draw(*handles, handle_in_use(), list_);
  }
  return list_;
}

const DrawList& Session::bare_picture() {
  if (changed_) {
    try {
      list_ = subject_.draw_list(state_);
      scene_lines_ = list_.lines.size();
      scene_marks_ = list_.marks.size();
    } catch (const Error& error) {
      message_ = error.what();  // the picture of before stays
    }
    changed_ = false;
    ++version_;
  }
  list_.lines.resize(scene_lines_);
  list_.marks.resize(scene_marks_);
  list_.captions.covered = list_.captions.covered_right = list_.captions.covered_below = 0;
  return list_;
}

bool Session::changing() const {
  return !state_.paused || flight_.has_value() ||
         (fly_.any() && state_.camera == CameraMode::fly) || !events_.empty();
}

bool Session::animating() const {
  return changing() || searching();
}

bool Session::moving() const {
  return changing() || drag_.has_value() || (press_ && press_->dragging);
}

}  // namespace soms::view
