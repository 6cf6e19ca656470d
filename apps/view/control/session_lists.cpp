// What of `Session` concerns lists: files to open, events, and the menu of orientation tests.
#include "apps/view/control/action.h"
#include "apps/view/control/camera_moves.h"
#include "apps/view/control/session.h"

#include <utility>

namespace soms::view {

void Session::take_in_files(const KeyPress& press) {
  switch (press.key) {
    case Key::up:
      state_.files->move(-1);
      return;
    case Key::down:
      state_.files->move(1);
      return;
    case Key::page_up:
      state_.files->move(-10);
      return;
    case Key::page_down:
      state_.files->move(10);
      return;
    case Key::backspace:
      state_.files->up();
      return;
    case Key::enter:
      state_.requests.open_chosen = true;
      return;
    case Key::escape:
      state_.files.reset();
      return;
    default:
      if (!press.control && press.key >= key_of('0') && press.key <= key_of('Z')) {
        state_.files->jump(static_cast<char>(press.key));
      }
  }
}

void Session::open_files(const std::vector<std::string>& paths) {
  std::size_t opened = 0;
  guarded([&] {
    for (const std::string& path : paths) {
      subject_.open(path);
      ++opened;
    }
  });
  state_.requests.fit_all = opened > 0;
  state_.event.reset();
  state_.at_event = false;
}

bool Session::searching() const {
  const bool listed = state_.events && state_.panels;
  return (listed || state_.requests.event_step != 0) && !subject_.events().done();
}

void Session::do_event_requests() {
  Requests& wishes = state_.requests;
  if (searching() && !attempted([&] { subject_.search_events(); })) {
    wishes.event_step = 0;
    state_.events = false;  // else it would fail again at once
  }
  const EventList& list = subject_.events();
  if (const auto row = std::exchange(wishes.event, std::nullopt); row && *row < list.rows.size()) {
    go_to_event(*row);
  }
  if (wishes.event_step == 0) {
    return;
  }
  const std::size_t from = state_.event.value_or(0);
  const bool back = wishes.event_step < 0;
  const std::size_t next = !state_.event ? 0 : back ? from - 1 : from + 1;
  if (next < list.rows.size()) {  // one before the first is beyond the last
    wishes.event_step = 0;
    go_to_event(next);
  } else if (list.done() || back) {
    wishes.event_step = 0;
    message_ = list.rows.empty() ? "nothing touches in the frames searched"
               : back            ? "this is the first event"
                                 : "this is the last event";
  }
}

void Session::go_to_event(std::size_t row) {
  const FitCamera fit = [this](const Box& box, const Vec3& toward_eye) {
    return fitted_beside(box, toward_eye, window_, covered_, camera_.field_of_view);
  };
  Sight sight;
  if (!guarded([&] { sight = subject_.show_event(row, fit); })) {
    return;
  }
  state_.paused = true;
  state_.camera = CameraMode::orbit;
  state_.event = row;
  state_.at_event = true;
  picked_ = sight.facts;
  state_.selected = true;
  go(sight.camera);
}

void Session::start_test(std::size_t row, std::uint64_t frame) {
  set_orientation_test(state_, row);
  state_.requests.fit_all = false;
  subject_.choose(state_);
  choice_ = choice(state_);
  subject_.seek(frame);
  changed_ = true;
  refresh();
  frame_again();
}

}  // namespace soms::view
