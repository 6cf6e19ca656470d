#include "apps/view/verbs/time_frames.h"

#include "soms/base/error.h"
#include "soms/thesis/named_overlap.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/model/traversal_keys.h"
#include "apps/output/json.h"
#include "apps/rows/pose_source.h"
#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/gl/headless_context.h"
#include "apps/view/scene/draw_scene.h"
#include "apps/view/scene/load.h"
#include "apps/view/verbs/render.h"
#include "apps/view/verbs/render_camera.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostPoses = 100'000;

const char* const kTimeFramesFooter =
    "Each frame moves the trees' boxes and finds all contacts by --traversal. Passes that\n"
    "draw nothing alternate with passes that draw each frame off screen until the driver has\n"
    "finished. Reading models, their first upload, and what finds the contacts that are marked red "
    "are not timed.\n"
    "Pictures are drawn without smoothing, shadows or shading of creases unless --samples is above "
    "1.\n\n"
    "Example:\n"
    "  soms generate city --triangles 20000 -o town.ply\n"
    "  soms generate car -o car.ply\n"
    "  printf 'x,y,z\\n0,0,0\\n1,0,0\\n' > poses.csv\n"
    "  soms-view time-frames town.ply --mover car.ply --pose poses.csv";

/// Milliseconds of finding contacts in a frame.
struct CollisionTime {
  double move = 0;
  double query = 0;
  std::size_t contacts = 0;
};

/// A frame in a pass that draws nothing and in one that draws each frame.
struct FrameTime {
  CollisionTime alone = {};
  CollisionTime drawn = {};
  double draw = 0;
};

double milliseconds(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double, std::milli>(to - from).count();
}

std::vector<Pose> read_poses(const std::string& name, const command::Console& console) {
  command::PoseSource source("--pose", name, console);
  const bool single = source.is_constant();
  std::vector<Pose> poses;
  while (const auto pose = source.next()) {
    if (poses.size() == kMostPoses) {
      throw Error(ErrorKind::usage, fmt::format("--pose {}: more than {} poses", name, kMostPoses),
                  "time fewer at a time");
    }
    poses.push_back(*pose);
    if (single) {
      break;
    }
  }
  return poses;
}

/// What is timed: a model that stands still and one that moves.
struct Timed {
  Body still;
  Shape mover;
  std::string mover_name;
};

Timed load(const TimeFramesOptions& options, command::Console& console) {
  command::WorldOptions world_options = options.world;
  if (world_options.movers.size() != 1 || world_options.cities.size() != 1 ||
      !world_options.routes.empty() || world_options.count) {
    throw Error(ErrorKind::usage, "time-frames moves one model past another",
                "give one CITY and one --mover, and neither --route nor --count");
  }
  world_options.count = 0;
  world_options.keep_trees = true;
  command::World world = command::load_world(world_options, console);
  const command::Model& model = world.models.front();
  Timed timed{world.city.front(), model.shape, model.name};
  if (options.mover_levels >= 0) {
    BuildOptions build = world_options.build;
    build.level = options.mover_levels;
    timed.mover = Shape(model.shape.shared_mesh(), {.build = build, .keep_tree = true});
  }
  return timed;
}

/// Times frames: trees that are moved and traversed beside a scene that is drawn.
class FrameClock {
 public:
  FrameClock(const TimeFramesOptions& options, const Timed& timed, const Pose& first,
             const Limits& limits)
      : options_(options),
        still_pose_(timed.still.pose),
        query_(timed.still.shape, timed.mover, options.traversal),
        scene_(two_bodies(timed.still, Body(timed.mover, first, timed.mover_name)), limits),
        camera_(place_camera({}, scene_, options.size, {}, limits)) {}

  CollisionTime find(const Pose& pose, const Limits& limits) {
    const auto start = Clock::now();
    query_.move(still_pose_, pose);
    const auto moved = Clock::now();
    const Overlap answer = query_(still_pose_, pose, {}, limits);
    const auto found = Clock::now();
    return {milliseconds(start, moved), milliseconds(moved, found), answer.pairs.size()};
  }

  double draw(const Pose& pose) {
    scene_.set_pose(0, pose);
    const auto placed = Clock::now();
    ViewOptions shown;
    shown.gap = false;  // its query is none of drawing
    renderer_.draw(draw_scene(scene_, shown).list, camera_, options_.size,
                   {.samples = options_.samples,
                    .relief = options_.samples > 1,
                    .shadows = options_.samples > 1});
    GlRenderer::finish();
    return milliseconds(placed, Clock::now());
  }

 private:
  const TimeFramesOptions& options_;
  Pose still_pose_;
  thesis::NamedOverlap query_;
  ViewScene scene_;
  Camera camera_;
  GlRenderer renderer_;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The median of a number over passes.
template <class Number>
double median_of(const std::vector<FrameTime>& passes, const Number& number) {
  std::vector<double> values;
  for (const FrameTime& pass : passes) {
    values.push_back(number(pass));
  }
  return median(std::move(values));
}

FrameTime median_frame(const std::vector<FrameTime>& passes) {
  FrameTime frame = passes.front();
  frame.alone.move = median_of(passes, [](const FrameTime& pass) { return pass.alone.move; });
  frame.alone.query = median_of(passes, [](const FrameTime& pass) { return pass.alone.query; });
  frame.drawn.move = median_of(passes, [](const FrameTime& pass) { return pass.drawn.move; });
  frame.drawn.query = median_of(passes, [](const FrameTime& pass) { return pass.drawn.query; });
  frame.draw = median_of(passes, [](const FrameTime& pass) { return pass.draw; });
  return frame;
}

/// Medians over passes that do not draw and passes that do, in turn.
std::vector<FrameTime> time_passes(FrameClock& clock, const std::vector<Pose>& poses, int passes,
                                   const Limits& limits) {
  (void)clock.find(poses.front(), limits);
  (void)clock.draw(poses.front());  // uploads the models
  std::vector<std::vector<FrameTime>> times(poses.size());
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < poses.size(); ++k) {
      times[k].push_back({.alone = clock.find(poses[k], limits)});
    }
    for (std::size_t k = 0; k < poses.size(); ++k) {
      check_stop(limits);
      times[k].back().drawn = clock.find(poses[k], limits);
      times[k].back().draw = clock.draw(poses[k]);
    }
  }
  std::vector<FrameTime> medians;
  medians.reserve(times.size());
  for (const std::vector<FrameTime>& of_frame : times) {
    medians.push_back(median_frame(of_frame));
  }
  return medians;
}

void report(const TimeFramesOptions& options, const std::vector<FrameTime>& frames,
            std::size_t triangles, command::Console& console) {
  if (console.shared().json) {
    command::Json rows = command::Json::array();
    for (const FrameTime& frame : frames) {
      rows.push_back({{"contacts", frame.drawn.contacts},
                      {"alone", {{"move_ms", frame.alone.move}, {"query_ms", frame.alone.query}}},
                      {"drawn",
                       {{"move_ms", frame.drawn.move},
                        {"query_ms", frame.drawn.query},
                        {"draw_ms", frame.draw}}}});
    }
    console.print(command::json_line({{"schema", "soms.time-frames/1"},
                                      {"device", GlRenderer::device()},
                                      {"width", options.size.width},
                                      {"height", options.size.height},
                                      {"samples", options.samples},
                                      {"passes", options.passes},
                                      {"triangles", triangles},
                                      {"frames", std::move(rows)}}));
    return;
  }
  double alone = 0;
  double drawn = 0;
  double drawing = 0;
  for (const FrameTime& frame : frames) {
    alone += frame.alone.move + frame.alone.query;
    drawn += frame.drawn.move + frame.drawn.query;
    drawing += frame.draw;
  }
  const auto count = static_cast<double>(frames.size());
  console.print(
      fmt::format("{}, {}x{}, drawn by {}\n"
                  "without drawing: collision {:.3g} ms a frame, {:.4g} frames a second\n"
                  "with drawing: collision {:.3g} ms, drawing {:.3g} ms, {:.4g} frames a second\n",
                  command::counted(frames.size(), "frame"), options.size.width, options.size.height,
                  GlRenderer::device(), alone / count, 1000 * count / alone, drawn / count,
                  drawing / count, 1000 * count / (drawn + drawing)));
}

}  // namespace

command::Action add_time_frames(command::Parser& parser, command::Shared&) {
  const auto options = std::make_shared<TimeFramesOptions>();
  options->world.build.rule = Rule::soms;
  command::add_world_options(parser, options->world);
  parser.add_option("--pose", options->pose, "CSV file of the mover's poses, a frame each")
      ->required()
      ->option_text("FILE");
  parser
      .add_option_function(
          "--size",
          [options](const std::string& text) { options->size = parse_picture_size(text); },
          "width and height in pixels, up to 16384x16384 (640x480)")
      ->option_text("WxH");
  command::add_count(parser, "--samples", options->samples, 1, 16,
                     "samples per pixel; above 1 creases are shaded, too (1)");
  command::add_count(parser, "--passes", options->passes, 1, 1000,
                     "passes over all frames; each time is the median of them (3)");
  command::add_count(parser, "--mover-levels", options->mover_levels, 0, 64,
                     "as --levels, for the tree of the mover (as --levels)");
  command::add_tree_list(parser, options->world.build);
  command::add_traversal_keys(parser, options->traversal);
  parser.footer(kTimeFramesFooter);
  return [options, &parser](command::Console& console) {
    command::check_build(parser, options->world.build);
    command::check_traversal(parser, options->traversal);
    if (parser.count("--traversal") > 0 && parser.count("--descent") == 0) {
      options->traversal.descent = TraversalOptions{}.descent;
    }
    options->traversal = without_idle(options->traversal);
    if (options->traversal.traversal == Traversal::fast) {
      throw Error(ErrorKind::usage, "--traversal fast has no boxes to move",
                  "choose another traversal, or leave it out");
    }
    return run_time_frames(*options, console);
  };
}

int run_time_frames(const TimeFramesOptions& options, command::Console& console) {
  // What may be missing is checked first, before models are read.
  const HeadlessContext context;
  const std::vector<Pose> poses = read_poses(options.pose, console);
  const Timed timed = load(options, console);
  const std::vector<FrameTime> frames = console.run("timing frames", [&](const Limits& limits) {
    const Limits one_thread = limits.alone();
    FrameClock clock(options, timed, poses.front(), one_thread);
    return time_passes(clock, poses, options.passes, one_thread);
  });
  const std::size_t triangles =
      timed.still.shape.mesh().triangles.size() + timed.mover.mesh().triangles.size();
  report(options, frames, triangles, console);
  return 0;
}

}  // namespace soms::view
