#include "apps/soms/simulate.h"
#include "apps/support/parse.h"

#include <memory>

namespace soms::command {

namespace {

constexpr std::uint64_t kMostFrames = 1'000'000'000;

const char* const kFooter =
    "Without a city: an embedded one of 1,000,000 triangles. Movers follow its streets, drones "
    "fly\n"
    "above them; in a city from files they go to and fro on straight level lines at street "
    "height.\n"
    "They start free, drive on through whatever they touch, and 60 frames are one second. A "
    "contact\n"
    "is one mover and one triangle of the city, or two movers, from the first frame in which they\n"
    "touch to the last. A route file is CSV: x,y,z are points of a line that is driven at "
    "constant\n"
    "speed; with qw,qx,qy,qz or as r00,...,tz each row is the pose of one frame.\n"
    "Surfaces only: a mover wholly inside a closed building touches nothing.\n\n"
    "Example:\n"
    "  soms simulate --map city.svg\n"
    "  soms generate city --triangles 20000 -o town.ply\n"
    "  soms generate car -o car.ply\n"
    "  soms simulate town.ply --mover car.ply --count 50 --frames 60 --events contacts.csv";

}  // namespace

Action add_simulate(CLI::App& app, Shared&) {
  const auto options = std::make_shared<SimulateOptions>();
  add_world_options(app, options->world);
  add_world_tree_options(app, options->world);
  const CLI::Option* frames =
      add_count(app, "--frames", options->frames, 0, kMostFrames, "frames (600)");
  app.add_flag("--verify", options->verify,
               "check contacts, and a sample of free movers, by brute force");
  add_output(app, "--map", options->map, "draw the city, its movers and contacts as SVG");
  add_output(app, "--report", options->report,
             "write an HTML report with figures, a time line and the scene in 3-D");
  add_output(app, "--events", options->events, "write begin and end of every contact as CSV");
  add_output(app, "--record", options->record,
             "write poses and contacts of every frame, to be played by soms view");
  app.add_flag("--view", options->view, "show it in a window instead of answering");
  add_output(app, "--picture", options->picture, "draw the last frame and its contacts as PNG");
  app.add_option_function<std::string>(
         "--picture-frame",
         [options](const std::string& value) {
           options->picture_frame = parse_count("--picture-frame", value, 0, kMostFrames);
         },
         "draw this frame instead, counted from 0")
      ->option_text("N");
  add_choice<bool>(app, "--fail-if", options->fail_if_contact,
                   {{"overlap", true}, {"contact", true}}, "exit with 1 when something touched");
  app.footer(kFooter);
  return [options, frames, &app](Console& console) {
    options->frames_given = frames->count() > 0;
    check_build(app, options->world.build);
    check_traversal(app, options->world.traversal);
    if (const std::string given = given_of_trees(app); options->view && !given.empty()) {
      throw Error(ErrorKind::usage, given + " with --view changes nothing",
                  "choose trees and traversals in the window");
    }
    return run_simulate(*options, console);
  };
}

}  // namespace soms::command
