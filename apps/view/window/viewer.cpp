#include "apps/view/window/viewer.h"

#include "soms/base/error.h"

#include "apps/view/control/detail.h"
#include "apps/view/control/frame_rates.h"
#include "apps/view/control/frame_times.h"
#include "apps/view/control/panels.h"
#include "apps/view/control/preset.h"
#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/picture_file.h"
#include "apps/view/window/app_window.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrame = 1.0 / 60;
/// Seconds after the last motion before all triangles are drawn again.
constexpr double kRestSeconds = 0.15;
/// Frames after an event: the panels answer to the mouse one frame late.
constexpr int kEcho = 3;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// What the picture of the scene depends on.
struct Drawn {
  std::uint64_t version = 0;
  Camera camera;
  Size size{0, 0};
  std::optional<Handle> handle;
  std::uint64_t most_triangles = 0;
  int samples = 0;
  double scale = 1;
  double density = 1;
  Covered covered;  ///< words stand beside it

  [[nodiscard]] bool operator==(const Drawn&) const = default;
};

/// A picture that is wanted, once the panels have come to rest.
struct Shot {
  std::filesystem::path path;
  bool panels = false;  ///< over it
  int frames = kEcho;   ///< still to draw before
};

/// \errors ErrorKind::cannot_write where a picture is wanted and the window was closed before it.
void check_picture(const ViewerOptions& options, std::uint64_t played) {
  if (options.screenshot.empty()) {
    return;
  }
  throw Error(ErrorKind::cannot_write,
              options.screenshot + ": the window was closed before its picture was finished" +
                  (options.frames ? ", " + std::to_string(played) + " of " +
                                        std::to_string(*options.frames) + " frames had run"
                                  : std::string()),
              options.frames ? "leave it open, or give fewer --frames" : "leave it open");
}

/// The first free name of a picture in the present folder.
std::filesystem::path free_name() {
  for (int i = 1;; ++i) {
    std::filesystem::path path = "soms-view-" + std::to_string(i) + ".png";
    if (!std::filesystem::exists(path)) {
      return path;
    }
  }
}

/// What is shown, as the options begin.
std::unique_ptr<Session> begun(Subject& subject, Size size, const ViewerOptions& options) {
  auto session = std::make_unique<Session>(subject, size);
  ViewState& state = session->state();
  state.panels = options.panels;
  begin_with(state, options.build, options.traversal);
  if (options.boxes) {
    show_traversed(state);
  }
  if (options.test) {
    session->start_test(options.test->row, options.test->frame);
  }
  const bool moves = session->facts().limits.moves;
  state.paused = !(options.run || options.frames) || !moves;
  if (moves && state.paused && !options.test && options.screenshot.empty()) {
    session->await_first_event();
  }
  return session;
}

/// The window, and what it shows.
struct Opened {
  Opened(const SubjectMaker& make, const ViewerOptions& options, const std::stop_token& stop)
      : window("soms view", options.size) {
    const Size size = window.size();
    CutMeshes cut;
    const auto work = [&](const Say& say) {
      subject = make(say);
      say("building trees and finding contacts", kNoShare);
      session = begun(*subject, size, options);
      const auto share = [&](double done) { say("cutting the picture in blocks", done); };
      share(0);
      Limits limits;
      limits.threads = 0;
      limits.progress = share;
      limits.stop = stop;
      cut.cut(session->bare_picture(), limits);
    };
    // The device compiles its shaders while models are read.
    const auto meanwhile = [this] { renderer = std::make_unique<GlRenderer>(); };
    ready = work_behind(window, work, meanwhile, events, stop);
    if (ready) {
      renderer->take(std::move(cut));
    }
  }

  AppWindow window;
  std::unique_ptr<Subject> subject;
  std::unique_ptr<Session> session;
  std::unique_ptr<GlRenderer> renderer;
  std::vector<InputEvent> events;  ///< that came meanwhile
  bool ready = false;              ///< else the window was closed
};

class Loop {
 public:
  Loop(Opened& opened, const ViewerOptions& options)
      : options_(options),
        window_(opened.window),
        renderer_(*opened.renderer),
        session_(*opened.session) {
    for (InputEvent& event : opened.events) {
      session_.push(std::move(event));
    }
    window_.set_title("soms view: " + session_.facts().name);
    detail_.begin(session_.facts().triangles);
    lay_out_panels();
  }

  void run(const std::stop_token& stop) {
    const std::stop_callback wake(stop, [] { AppWindow::wake(); });
    while (!over(stop)) {
      window_.wait(patience());
      take_events();
      const Size pixels = window_.pixels();
      if (due_ > 0 && pixels.width > 0 && pixels.height > 0) {
        frame(pixels);
        --due_;
      } else {
        due_ = 0;  // an icon, or nothing to draw
      }
    }
    if (!finished_ && !stop.stop_requested()) {
      check_picture(options_, played_);
    }
  }

 private:
  /// Panels know their places from the frame before: none that is shown is the first.
  void lay_out_panels() {
    for (int i = 0; i < kEcho; ++i) {
      window_.begin_panels();
      panels_.draw(session_, times_, rates_, renderer_.statistics());
      window_.end_panels();
    }
  }

  [[nodiscard]] bool over(const std::stop_token& stop) const {
    return stop.stop_requested() || window_.close_requested() || session_.state().requests.quit ||
           finished_;
  }

  /// True where the viewer ends by itself.
  [[nodiscard]] bool scripted() const {
    return options_.frames.has_value() || !options_.screenshot.empty();
  }

  /// True while frames of `ViewerOptions::frames` are to come.
  [[nodiscard]] bool playing() const { return played_ < options_.frames.value_or(0); }

  /// Seconds to wait for events; negative: until one comes.
  [[nodiscard]] double patience() const {
    if (scripted() || shot_) {
      return due_ == 0 ? kFrame : 0;  // an icon has nothing to draw
    }
    if (due_ > 0 || session_.animating()) {
      return std::max(0.0, kFrame - seconds_between(last_, Clock::now()));
    }
    return care_ == Care::full ? -1 : rested() ? 0 : kRestSeconds;
  }

  void take_events() {
    bool touched = false;
    for (InputEvent& event : window_.take_events(touched)) {
      session_.push(std::move(event));
    }
    if (touched) {
      due_ = kEcho;
    }
    if (session_.animating() || scripted() || shot_ || (care_ != Care::full && rested())) {
      due_ = std::max(due_, 1);
    }
  }

  [[nodiscard]] bool rested() const {
    return seconds_between(moved_, Clock::now()) >= kRestSeconds;
  }

  void frame(Size pixels) {
    const Clock::time_point begin = Clock::now();
    const double passed = seconds_between(std::exchange(last_, begin), begin);
    session_.resize(window_.size(), window_.point());
    window_.begin_panels();
    session_.handle(captured());
    session_.tick(scripted() ? (playing() ? kFrame : 0) : passed);
    do_window_requests();
    panels_.draw(session_, times_, rates_, renderer_.statistics());
    draw_scene(pixels, begin);
    renderer_.present();
    window_.end_panels();
    window_.finish();
    rates_.add(session_.state(), session_.facts(), 1000 * seconds_between(begin, Clock::now()));
    go_on();
    take_picture(pixels);
    times_.add(1000 * seconds_between(begin, Clock::now()), passed);
    window_.show();
  }

  /// Draws the scene, unless the picture of before still holds.
  void draw_scene(Size pixels, Clock::time_point begin) {
    if (session_.moving() || session_.handle_in_use() != drawn_.handle) {
      moved_ = begin;
    }
    const DrawList& list = session_.picture();
    const bool quick = !shot_ && (scripted() || !rested());
    const Care care = quick ? Care::moving : shot_ ? Care::full : detail_.next(care_);
    if (!draw_with(care, list, pixels)) {
      // What came needs an answer at once; the rest of the picture can wait.
      moved_ = Clock::now();
      due_ = std::max(due_, 1);
      (void)draw_with(Care::moving, list, pixels);
    }
  }

  /// Draws with some care, unless the picture of before has it; false if an event stopped it.
  bool draw_with(Care care, const DrawList& list, Size pixels) {
    const DrawOptions options = as_cut(detail_.options(care, session_.facts().triangles));
    const Drawn now{
        session_.version(),     session_.camera(), pixels,        session_.handle_in_use(),
        options.most_triangles, options.samples,   options.scale, options.density,
        session_.covered()};
    care_ = options.samples > 1 ? Care::full : care;
    if (now == drawn_) {
      return true;
    }
    const Clock::time_point start = Clock::now();
    if (!draw_unless_disturbed(care, list, pixels, options)) {
      return false;
    }
    drawn_ = now;
    const DrawStatistics statistics = renderer_.statistics();
    const double ms = 1000 * seconds_between(start, Clock::now());
    if (care == Care::whole) {
      return true;  // says nothing of either budget
    }
    if (statistics.uploads == 0) {
      detail_.add(ms, statistics.triangles, options);
    } else {
      detail_.add_with_uploads(ms);
    }
    return true;
  }

  /// A picture with more care than one that moves is given up for what the user does meanwhile.
  bool draw_unless_disturbed(Care care, const DrawList& list, Size pixels,
                             const DrawOptions& options) {
    std::stop_source disturbed;
    if (care != Care::moving && !shot_) {
      Limits watched;
      watched.stop = disturbed.get_token();
      watched.progress = [&](double) {
        if (window_.wants_answer()) {
          disturbed.request_stop();
        }
      };
      renderer_.watch(watched);
    }
    try {
      renderer_.draw(list, session_.camera(), pixels, options);
      window_.finish();
    } catch (const Error& error) {
      renderer_.watch({});
      if (error.kind() != ErrorKind::cancelled) {
        throw;
      }
      drawn_ = {};
      return false;
    }
    renderer_.watch({});
    return true;
  }

  /// On this display. What is cut away would still cast its shadow.
  [[nodiscard]] DrawOptions as_cut(DrawOptions options) const {
    options.density = window_.density();
    options.shadows = options.shadows && session_.camera().cut == 0;
    return options;
  }

  void do_window_requests() {
    Requests& wishes = session_.state().requests;
    if (std::exchange(wishes.fullscreen, false)) {
      window_.toggle_fullscreen();
    }
    const bool bare = std::exchange(wishes.screenshot, false);
    const bool panels = std::exchange(wishes.screenshot_panels, false);
    if ((bare || panels) && !shot_) {
      shot_ = Shot{free_name(), panels};
    }
  }

  /// Counts the frame of a script, and ends it.
  void go_on() {
    if (playing()) {
      ++played_;
    } else if (!options_.screenshot.empty() && !shot_) {
      session_.state().paused = true;
      shot_ = Shot{options_.screenshot, options_.screenshot_panels};
    }
    finished_ = finished_ || (scripted() && !playing() && options_.screenshot.empty());
  }

  /// Takes the picture that is wanted, if it is its time.
  void take_picture(Size pixels) {
    if (!shot_ || shot_->frames-- > 0) {
      return;
    }
    const Shot shot = *std::exchange(shot_, std::nullopt);
    try {
      write_png(shot.panels ? window_.read_pixels() : bare_picture(pixels), shot.path);
      session_.set_message("saved " + shot.path.string());
    } catch (const Error& error) {
      if (shot.path == options_.screenshot) {
        throw;
      }
      session_.set_message(error.what());
    }
    finished_ = finished_ || shot.path == options_.screenshot;
    due_ = std::max(due_, 2);
  }

  /// The scene in full, without handles and panels.
  Picture bare_picture(Size pixels) {
    renderer_.draw(session_.bare_picture(), session_.camera(), pixels, as_cut({}));
    drawn_ = {};
    return renderer_.read_pixels();
  }

  ViewerOptions options_;
  AppWindow& window_;
  GlRenderer& renderer_;
  Session& session_;
  Panels panels_;
  FrameTimes times_;
  FrameRates rates_;
  Detail detail_;
  Drawn drawn_;
  Clock::time_point last_ = Clock::now();
  Clock::time_point moved_ = Clock::now();  ///< the first picture is needed at once
  Care care_ = Care::moving;                ///< of the last picture
  int due_ = kEcho;
  std::optional<Shot> shot_;
  std::uint64_t played_ = 0;  ///< of `ViewerOptions::frames`
  bool finished_ = false;     ///< all of a script is done
};

}  // namespace

void run_viewer(const SubjectMaker& make, const ViewerOptions& options,
                const std::stop_token& stop) {
  Opened opened(make, options, stop);
  if (opened.ready) {
    Loop(opened, options).run(stop);
  } else if (!stop.stop_requested()) {
    check_picture(options, 0);
  }
}

}  // namespace soms::view
