#include "apps/view/window/opening.h"

#include "soms/base/error.h"

#include "apps/view/control/opening_panel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

namespace soms::view {

namespace {

/// Seconds between two pictures of the progress.
constexpr double kTick = 0.1;

/// A thread that works, and what it says.
class Worker {
 public:
  explicit Worker(const std::function<void(const Say&)>& work)
      : thread_([this, work] { run(work); }) {}

  ~Worker() {
    unwanted_ = true;
    join();
  }

  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  [[nodiscard]] bool over() const { return over_; }

  [[nodiscard]] std::pair<std::string, double> said() {
    const std::scoped_lock lock(mutex_);
    return said_;
  }

  /// Waits for the end. \errors Those of the work.
  void finish() {
    join();
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }

 private:
  void join() {
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  void run(const std::function<void(const Say&)>& work) {
    try {
      work([this](const std::string& doing, double share) { say(doing, share); });
    } catch (...) {
      failure_ = std::current_exception();
    }
    over_ = true;
    AppWindow::wake();
  }

  void say(const std::string& doing, double share) {
    if (unwanted_) {
      throw Error(ErrorKind::cancelled, "the window was closed", "");
    }
    const std::scoped_lock lock(mutex_);
    said_ = {doing, share};
  }

  std::mutex mutex_;
  std::pair<std::string, double> said_{"starting", 0};
  std::atomic<bool> unwanted_ = false;
  std::atomic<bool> over_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  ///< last: it uses the others
};

bool wants_end(const std::vector<InputEvent>& events) {
  return std::any_of(events.begin(), events.end(), [](const InputEvent& event) {
    const auto* const down = std::get_if<KeyDown>(&event);
    return down != nullptr && (down->press.key == Key::escape ||
                               (down->press.control && down->press.key == key_of('Q')));
  });
}

void show_said(AppWindow& window, Worker& worker) {
  const auto [doing, share] = worker.said();
  window.clear();
  window.begin_panels();
  draw_opening(doing, share);
  window.end_panels();
  window.show();
}

}  // namespace

bool work_behind(AppWindow& window, const std::function<void(const Say&)>& work,
                 const std::function<void()>& meanwhile, std::vector<InputEvent>& events,
                 const std::stop_token& stop) {
  Worker worker(work);
  const std::stop_callback wake(stop, [] { AppWindow::wake(); });
  for (bool first = true; first || !worker.over(); first = false) {
    bool touched = false;
    auto more = window.take_events(touched);
    events.insert(events.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
    if (window.close_requested() || stop.stop_requested() || wants_end(events)) {
      window.hide();  // the work may take a while to end
      return false;
    }
    show_said(window, worker);
    if (first) {
      meanwhile();
    } else {
      window.wait(kTick);
    }
  }
  worker.finish();
  return !window.close_requested() && !stop.stop_requested();
}

}  // namespace soms::view
