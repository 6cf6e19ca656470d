#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/soms/simulate/simulate.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace soms::command {

namespace {

constexpr std::uint64_t kMostFrames = 1'000'000'000;

const char* const kFooter =
    "Without CITY, an embedded city of 1,000,000 triangles is used. Movers follow its streets,\n"
    "and drones fly above them. In a city from files, movers go back and forth on straight, level\n"
    "lines at street height. Movers start free of contact and pass through whatever they touch.\n"
    "60 frames are one second. A contact is one mover and one triangle of the city, or two\n"
    "movers, from the first frame in which they touch to the last. With --clearance, so is\n"
    "what stays within that distance: a mover and a model of the city, or two movers. A route is\n"
    "a CSV file: x,y,z are points of a line that is followed at constant speed; with\n"
    "qw,qx,qy,qz, or as r00,...,tz, each row is the pose of one frame.\n"
    "Only surfaces are tested: a mover entirely inside a closed building touches nothing.\n\n"
    "Example:\n"
    "  soms simulate -o city.svg\n"
    "  soms generate city --triangles 20000 -o town.ply\n"
    "  soms generate car -o car.ply\n"
    "  soms simulate town.ply --mover car.ply --count 50 --frames 60 -o events.csv";

/// The keys of trees and traversals that were given, with their values.
std::vector<std::string> words_of_trees(const Parser& parser) {
  const Option* const list = parser.option("--tree");
  std::string keys;
  for (const Option* const option : parser.options()) {
    if (option->list() == list && option->count() > 0) {
      keys += fmt::format("{}{}={}", keys.empty() ? "" : ",", option->name().substr(2),
                          option->results().front());
    }
  }
  return keys.empty() ? std::vector<std::string>() : std::vector<std::string>{"--tree", keys};
}

}  // namespace

std::vector<OutputKind> simulate_files(SimulateOptions& options) {
  return {{{".csv"}, &options.events, ".csv (who touches what, when)", "--events"},
          {{".svg"}, &options.map, ".svg (a map)", "--map"},
          {{".html", ".htm"}, &options.report, ".html (a page)", "--report"},
          {{".png"}, &options.picture, ".png (a frame)", "--picture"},
          {{".json"}, &options.answer, ".json"}};
}

Action add_simulate(Parser& parser, Shared&) {
  const auto options = std::make_shared<SimulateOptions>();
  add_world_options(parser, options->world);
  add_tree_list(parser, options->world.build);
  options->traversal = add_traversal_by_name(parser);
  const Option* frames =
      add_count(parser, "--frames", options->frames, 1, kMostFrames,
                "number of frames (600; with --route of poses, as many as the longest has rows)");
  parser.add_flag("--verify", options->verify,
                  "check contacts, and a sample of free movers, by brute force");
  parser.add_flag_callback(
      "--no-between-movers", [options] { options->between_movers = false; },
      "test movers against the city alone, not against each other");
  add_repeatable(parser, "--ignore-pair", options->ignored,
                 "do not test two movers against each other, as neighboring links of\n"
                 "a robot; each is a number as in events or the name of a model;\nmay be repeated",
                 "A,B")
      ->old_name("--ignore", has_comma);
  add_positive(parser, "--clearance", options->clearance,
               "report what comes within this distance (above 0), too, and how\n"
               "near; maps, pages and pictures draw it, --record keeps it");
  parser.add_flag("--swept", options->swept,
                  "report what is touched between two frames, too, so that nothing\n"
                  "passes through anything unseen");
  add_outputs(parser, simulate_files(*options), "Options",
              "write a file, by its extension; may be repeated:\n");
  add_output(parser, "--contacts", options->contacts,
             "write the beginning and end of every contact, triangle by triangle, as CSV");
  add_output(parser, "--record", options->record,
             "write poses and contacts (and gaps) of every frame; soms view plays the\n"
             "file");
  parser.add_flag("--view", options->view,
                  "show the simulation in a window instead of reporting it");
  parser
      .add_option_function(
          "--picture-frame",
          [options](const std::string& value) {
            options->picture_frame = parse_count("--picture-frame", value, 0, kMostFrames);
          },
          "frame that -o FILE.png draws, counted from 0 (the last)")
      ->option_text("N");
  add_choice<FailIf>(
      parser, "--fail-if", options->fail_if,
      {{"overlap", FailIf::contact}, {"contact", FailIf::contact}, {"near", FailIf::near}},
      "exit with status 1 if anything touches (with --swept, between\nframes, too), or comes "
      "within the --clearance");
  parser.footer(kFooter);
  return [options, frames, &parser](Console& console) {
    options->frames_given = frames->count() > 0;
    check_build(parser, options->world.build);
    options->traversal->check(parser);
    options->world.keep_trees = options->traversal->named();
    options->tree_words = words_of_trees(parser);
    return run_simulate(*options, console);
  };
}

}  // namespace soms::command
