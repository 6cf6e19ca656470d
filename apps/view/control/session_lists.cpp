// What of `Session` concerns lists: files to open, events, and the menu of orientation tests.
#include "apps/cli/text.h"
#include "apps/view/control/action.h"
#include "apps/view/control/camera_moves.h"
#include "apps/view/control/session.h"

#include <algorithm>
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
  const bool wanted = state_.requests.event_step != 0 || state_.requests.event || awaits_first_;
  return (listed || wanted) && !subject_.events().done();
}

namespace {

/// True once the search knows all frames of an event: its row does not change any more.
bool is_over(const EventList& list, std::size_t row) {
  return list.done() || list.rows[row].end + 1 < list.searched;
}

}  // namespace

void Session::do_event_requests() {
  Requests& wishes = state_.requests;
  if (searching() && !attempted([&] { subject_.search_events(); })) {
    wishes.event_step = 0;
    wishes.event.reset();
    awaits_first_ = false;
    state_.events = false;  // else it would fail again at once
  }
  const EventList& list = subject_.events();
  if (wishes.event && *wishes.event >= list.rows.size()) {
    wishes.event.reset();
  }
  if (wishes.event_step != 0) {
    step_events();
  }
  if (wishes.event && is_over(list, *wishes.event)) {
    go_to_event(*std::exchange(wishes.event, std::nullopt), true);
  } else if (wishes.event) {
    message_.clear();  // a line says how far the search has come
  }
  if (awaits_first_) {
    go_to_first_event();
  }
}

void Session::step_events() {
  Requests& wishes = state_.requests;
  const EventList& list = subject_.events();
  const std::size_t from = state_.event.value_or(0);
  const bool back = wishes.event_step < 0;
  const std::size_t next = !state_.event ? 0 : back ? from - 1 : from + 1;
  if (next < list.rows.size()) {  // one before the first is beyond the last
    wishes.event_step = 0;
    wishes.event = next;
  } else if (list.done() || back) {
    wishes.event_step = 0;
    message_ = list.rows.empty() ? "nothing touches in the frames searched"
               : back            ? "this is the first event"
                                 : "this is the last event";
  } else {
    message_.clear();
  }
}

/// The picture is left bare: what is known of the contact has no panel.
void Session::go_to_first_event() {
  const EventList& list = subject_.events();
  if (!state_.paused || state_.orientation_test) {
    awaits_first_ = false;
    return;
  }
  const auto row = std::find_if(list.rows.begin(), list.rows.end(), [&](const ContactEvent& event) {
    return is_over(list, static_cast<std::size_t>(&event - list.rows.data()));
  });
  if (row == list.rows.end()) {
    awaits_first_ = !list.done();
    return;
  }
  awaits_first_ = false;
  go_to_event(static_cast<std::size_t>(row - list.rows.begin()), false);
  first_message_ = "frame " + command::with_commas(row->most_frame) + ": " + row->title +
                   "; F3 goes to the next event, Enter shows everything";
  message_ = first_message_;
}

/// What is picked changes with time, and a contact may end.
void Session::renew_picked() {
  const std::pair now{facts_.frame, facts_.object};
  if (!state_.selected || now == picked_at_) {
    return;
  }
  picked_at_ = now;
  if (message_ == first_message_) {
    message_.clear();
  }
  std::optional<PickedFacts> facts = subject_.selection();
  if (!facts) {
    subject_.deselect();
    picked_.reset();
    state_.selected = state_.at_event = false;
    changed_ = true;
  } else if (picked_) {
    picked_ = std::move(facts);
  }
}

void Session::go_to_event(std::size_t row, bool with_panel) {
  const FitCamera fit = [this, with_panel](const Box& box, const Vec3& toward_eye) {
    const Covered beside{covered_.left,
                         std::max(covered_.right, with_panel ? right_of_picked_ : 0)};
    return fitted_beside(box, toward_eye, window_, beside, camera_.field_of_view);
  };
  Sight sight;
  if (!guarded([&] { sight = subject_.show_event(row, fit); })) {
    return;
  }
  state_.paused = true;
  state_.camera = CameraMode::orbit;
  state_.event = row;
  state_.at_event = true;
  picked_ = with_panel ? std::optional(sight.facts) : std::nullopt;
  state_.selected = true;
  refresh();
  picked_at_ = {facts_.frame, facts_.object};
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
