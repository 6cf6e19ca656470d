#include "apps/view/verbs/view.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/output/output.h"
#include "apps/view/scene/orientation_menu.h"
#include "apps/view/verbs/render_scene.h"
#include "apps/view/verbs/tree_options.h"
#include "apps/view/window/scene_subject.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace soms::view {

namespace {

constexpr std::uint64_t kLeastSide = 320;
constexpr std::uint64_t kMostSide = 16'384;
constexpr std::uint64_t kMostFrames = 1'000'000'000;

/// A search for the nearest points may not hold up a frame longer.
constexpr std::chrono::milliseconds kGapPatience{20};

/// Nor a slow traversal that was chosen; its counts say that they are of a part.
constexpr std::chrono::milliseconds kStepPatience{200};

const char* const kViewFooter =
    "Without CITY, an embedded city of 1,000,000 triangles is used, with cars, persons and\n"
    "drones. A city from files has movers only if --mover, --route or --count is given. Press H\n"
    "in the window to see all keys. The left mouse button rotates the view, the middle button\n"
    "moves it, and the wheel zooms in on the point under the cursor. A click selects a triangle,\n"
    "and the handles move the object. Drop a model file on the window to add it to the scene. To\n"
    "play a recording of soms simulate --record, give it as the only file.\n\n"
    "Example:\n"
    "  soms generate city --triangles 20000 -o town.ply\n"
    "  soms generate car -o car.ply\n"
    "  soms view town.ply --mover car.ply --count 20";

Size parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) {
    throw Error(ErrorKind::usage, "--size " + text, "give width and height, such as 1280x720");
  }
  const auto side = [](const std::string& digits) {
    return static_cast<int>(command::parse_count("--size", digits, kLeastSide, kMostSide));
  };
  return {side(text.substr(0, cross)), side(text.substr(cross + 1))};
}

/// The thesis shows its boxes. \errors ErrorKind::usage for a traversal that has none.
void check_boxes(const command::Parser& parser, ViewerOptions& viewer) {
  const bool is_fast = viewer.traversal.traversal == Traversal::fast;
  if (viewer.boxes && is_fast && parser.count("--traversal") > 0) {
    throw Error(ErrorKind::usage, "--trace: --traversal fast visits no boxes of the trees",
                "choose another traversal, or leave it out");
  }
  viewer.boxes = viewer.boxes || (parser.count("--thesis") > 0 && !is_fast);
}

}  // namespace

command::Action add_view(command::Parser& parser, command::Shared&) {
  const auto options = std::make_shared<ViewVerbOptions>();
  command::add_world_options(parser, options->world);
  describe_count(parser);
  parser
      .add_option("--pose", options->pose,
                  "pose of the mover: \"x y z [qw qx qy qz]\", or a CSV file of poses,\n"
                  "which are drawn all at once")
      ->option_text("POSE");
  parser
      .add_option_function(
          "--size", [options](const std::string& text) { options->viewer.size = parse_size(text); },
          "width and height of the window (1280x720)")
      ->option_text("WxH");
  add_test(parser, options->test, "begin with an orientation test of the one --mover");
  command::add_count(parser, "--frame", options->frame, 0, kMostFrames,
                     "frame of --test to begin with (that in which most touches; with --run or\n"
                     "--frames the first)");
  parser.add_flag("--run", options->viewer.run, "start running, not still at the first contact");
  parser.add_flag_callback(
      "--no-panels", [options] { options->viewer.panels = false; }, "start without panels");
  parser
      .add_option("--screenshot", options->viewer.screenshot,
                  "save the finished picture as PNG and close; after --frames if given")
      ->option_text("FILE");
  parser.add_flag("--with-panels", options->viewer.screenshot_panels,
                  "the picture of --screenshot shows the panels");
  parser
      .add_option_function(
          "--frames",
          [options](const std::string& text) {
            options->viewer.frames = command::parse_count("--frames", text, 1, kMostFrames);
          },
          "run this many frames, each a sixtieth of a second, then close")
      ->option_text("N");
  ViewerOptions& viewer = options->viewer;
  parser.add_flag("--trace", viewer.boxes,
                  "show the boxes that the traversal visited, pruned and found, by --traversal\n"
                  "(e-node with --descent larger)");
  add_tree_options(parser, viewer.build, viewer.traversal);
  parser.footer(kViewFooter);
  return [options, &parser](command::Console& console) {
    check_tree_options(parser, options->viewer.build, options->viewer.traversal);
    check_boxes(parser, options->viewer);
    return run_view(*options, console);
  };
}

namespace {

/// The test that the options name and its frame.
std::optional<StartedTest> started_test(const ViewVerbOptions& options) {
  if (options.test.empty()) {
    if (options.frame) {
      throw Error(ErrorKind::usage, "--frame has no effect without --test",
                  "also give --test, or leave it out");
    }
    return std::nullopt;
  }
  const std::uint64_t frames = frame_count(options.test);
  if (options.frame && *options.frame >= frames) {
    throw Error(ErrorKind::usage, fmt::format("--frame {}", *options.frame),
                fmt::format("there are frames from 0 to {} only", frames - 1));
  }
  const bool plays = options.viewer.run || options.viewer.frames;
  return StartedTest{orientation_row(options.test),
                     options.frame.value_or(plays ? 0 : fullest_frame(options.test))};
}

/// What is done before there is a scene.
std::string reading_in_words(const command::WorldOptions& world) {
  if (world.cities.empty()) {
    return "making the embedded city";
  }
  return "reading " + command::short_name(world.cities.front()) +
         (world.cities.size() + world.movers.size() > 1 ? " and other models" : "");
}

}  // namespace

int run_view(const ViewVerbOptions& options, command::Console& console) {
  ViewerOptions viewer = options.viewer;
  viewer.test = started_test(options);
  if (options.viewer.screenshot_panels && options.viewer.screenshot.empty()) {
    throw Error(ErrorKind::usage, "--with-panels needs --screenshot",
                "add --screenshot FILE, or press Shift+F12 in the window");
  }
  command::check_extension("--screenshot", options.viewer.screenshot, {".png"});
  command::WorldOptions world = options.world;
  world.guess_up = true;
  const SubjectMaker make = [&](const Say& say) {
    say(reading_in_words(world), kNoShare);
    SceneContent content = options.test.empty() ? load_content(world, options.pose, console)
                                                : load_tested(world, options.pose, console);
    const double meters =
        meters_of_unit(world, content.recording != nullptr,
                       content.city.empty() ? 0 : content.city.front().shape.mesh().unit);
    auto subject =
        std::make_unique<SceneSubject>(std::move(content), console.limits().without_deadline());
    subject->set_gap_patience(kGapPatience);
    subject->set_step_patience(kStepPatience);
    subject->set_meters(meters);
    return subject;
  };
  run_viewer(make, viewer, console.limits().stop);
  if (console.interrupted()) {
    throw Error(ErrorKind::cancelled, "interrupted", "");
  }
  return 0;
}

}  // namespace soms::view
