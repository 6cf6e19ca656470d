#include "apps/soms/thesis/thesis.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/traversal_keys.h"
#include "apps/output/output.h"
#include "apps/soms/thesis/thesis_lists.h"
#include "apps/soms/thesis/thesis_output.h"
#include "apps/soms/thesis/thesis_picture.h"
#include "apps/soms/thesis/thesis_run.h"
#include "apps/soms/thesis/thesis_trips.h"
#include "apps/soms/thesis/thesis_verb.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace soms::command {

namespace {

constexpr const char* kTestGroup = "Test";

constexpr const char* kFooter =
    "Without A the experiment of the thesis runs: its bunny, Venus and teapot each against its\n"
    "like, from the right, the left, above and below, and the drive of the bunny through the\n"
    "urban scene. Models that --models does not give are generated. In 49 frames the moving\n"
    "model comes in: roots touch in frame 32 (by rounding 33), and it is half inside in frame 48. "
    "Trees and\n"
    "traversal are those of the thesis where no option says otherwise. Contacts are exact.\n\n"
    "Example:\n"
    "  soms generate knot --triangles 2000 -o knot.ply\n"
    "  soms thesis knot.ply --test right\n"
    "  soms thesis --test right --csv frames.csv";

Choices<std::string> test_choices() {
  Choices<std::string> choices;
  for (const auto& [from, name] : kAllApproaches) {
    choices.emplace_back(name, name);
  }
  choices.emplace_back(kDriveTest, kDriveTest);
  choices.emplace_back(kAllTests, kAllTests);
  return choices;
}

void add_tests(Parser& parser, ThesisOptions& options) {
  parser.add_option("A", options.a, "model that does not move (default: the models of the thesis)");
  parser.add_option("B", options.b, "model that moves (A)");
  add_choice<std::string>(
      parser, "--test", options.test, test_choices(),
      "side from which B comes, drive (through A), or all: every side and,\n"
      "without A, the drive (the thesis' four sides and, without A, its drive)\n")
      ->group(kTestGroup);
  add_choice<bool>(parser, "--frames", options.all_frames, {{"overlap", false}, {"all", true}},
                   "frames in the table of one test: those in which the roots overlap, or all\n"
                   "(overlap)")
      ->group(kTestGroup);
  add_count(parser, "--repeat", options.repetitions, 1, 10'000,
            fmt::format("runs of which times are the median ({})", options.repetitions))
      ->group(kTestGroup);
  parser
      .add_option("--models", options.models,
                  "folder of the thesis' models: bun_zipper_res4.ply, venus.ply, teapot_1177.ply,\n"
                  "teapot.ply, there or in its folder ply; .3ds scenes there or in scenes")
      ->option_text("DIR")
      ->group("Models");
}

void add_results(Parser& parser, ThesisOptions& options) {
  add_output(parser, "--csv", options.csv, "write the frames as CSV, one row per frame");
  add_repeatable(parser, "-o,--output", options.outputs,
                 "write the tests to a file, by its extension: .csv or .json; may be repeated",
                 "FILE");
  Option* const picture = add_output(
      parser, "--picture", options.picture,
      "draw the first frame in which roots overlap, the first contact and the\nlast frame "
      "of each test, as PNG in this folder",
      "DIR");
  parser.add_flag("--view", options.view, "show the test in a window instead")->excludes(picture);
}

/// Adds the options of trees with the defaults of the thesis, and --level for --levels.
void add_trees(Parser& parser, ThesisOptions& options) {
  add_build_options(parser, options.build);
  Option* const levels = parser.option("--levels");
  levels->description(
      "maximum number of levels; 0: no limit (15; of a scene to drive\nthrough 13)");
  const std::string group = levels->group();
  add_count(parser, "--level", options.build.level, 0, 64, "the same as --levels")
      ->excludes(levels)
      ->group(group);
  // Their words name the defaults of other verbs.
  parser.option("--midpoint")->purpose("point that represents a triangle (thesis)");
  parser.option("--empty-side")->purpose("action when one side is empty (stop)");
  add_traversal_options(parser, options.traversal);
}

/// \errors ErrorKind::usage for an option that would change nothing beside the others.
void check_effects(const Parser& parser, const ThesisOptions& options) {
  const auto needs = [&](const char* option, bool there, const char* other) {
    if (parser.count(option) > 0 && !there) {
      throw Error(ErrorKind::usage, fmt::format("{} has no effect without {}", option, other),
                  fmt::format("also give {}, or leave it out", other));
    }
  };
  for (const char* const option : {"--scale", "--up", "--strict"}) {
    needs(option, !options.a.empty(), "A");
  }
  for (const char* const option : {"--scale-b", "--up-b"}) {
    needs(option, !options.b.empty(), "B");
  }
  if (!options.a.empty() && parser.count("--models") > 0) {
    throw Error(ErrorKind::usage, "--models has no effect beside A",
                "leave A out to run the models of the thesis, or leave --models out");
  }
  if (options.traversal.traversal == Traversal::fast) {
    throw Error(ErrorKind::usage,
                "--traversal fast does not traverse the trees of the thesis, and counts nothing",
                "name another traversal; soms overlap has fast");
  }
}

/// \errors ErrorKind::usage, in words of the command, for options that do not go together.
void settle(const Parser& parser, ThesisOptions& options) {
  options.model_b.strict = options.model_a.strict;
  options.levels_are_given = parser.count("--levels") + parser.count("--level") > 0;
  check_effects(parser, options);
  // What the thesis' options set and another rule does not use is no fault.
  if (given_of(parser, idle_options(options.build)).empty()) {
    options.build = without_idle(options.build);
  }
  check_build(parser, options.build);
  check_traversal(parser, options.traversal);
}

void check_files(const ThesisOptions& options) {
  if (options.a == "-" && options.b == "-") {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  if ((options.a == "-" || options.b == "-") && (options.view || !options.picture.empty())) {
    throw Error(ErrorKind::usage, "--view and --picture cannot read a model from standard input",
                "give the model as a file");
  }
  NamedFiles outputs{{"--csv", options.csv}, {"--picture", options.picture}};
  for (const std::string& output : options.outputs) {
    check_extension("-o", output, {".csv", ".json"});
    outputs.emplace_back("-o", output);
  }
  check_extension("--csv", options.csv, {".csv"});
  check_outputs({{"A", options.a}, {"B", options.b}}, outputs);
}

/// The requested lists: opened before the work, written after it.
class ThesisLists {
 public:
  explicit ThesisLists(const ThesisOptions& options) {
    if (!options.csv.empty()) {
      tables_.push_back(std::make_unique<OutputFile>(options.csv));
    }
    for (const std::string& output : options.outputs) {
      (extension_of(output) == ".csv" ? tables_ : documents_)
          .push_back(std::make_unique<OutputFile>(output));
    }
  }

  void write(const ThesisReport& report) const {
    for (const auto& file : tables_) {
      write_thesis_csv(file->stream(), report);
      file->commit();
    }
    for (const auto& file : documents_) {
      file->stream() << json_line(thesis_json(report));
      file->commit();
    }
  }

 private:
  std::vector<std::unique_ptr<OutputFile>> tables_;
  std::vector<std::unique_ptr<OutputFile>> documents_;
};

std::vector<ThesisResult> run_trips(std::vector<ThesisTrip> trips, const ThesisOptions& options,
                                    const Console& console) {
  std::vector<ThesisResult> results;
  for (ThesisTrip& trip : trips) {
    const std::string doing = fmt::format("test {} of {}", trip.trip.test, trip.trip.moving);
    results.push_back(console.run(doing, [&](const Limits& limits) {
      return run_trip(std::move(trip), options.traversal, options.repetitions, limits);
    }));
  }
  return results;
}

Action add_thesis(Parser& parser, Shared&) {
  const auto options = std::make_shared<ThesisOptions>();
  add_tests(parser, *options);
  add_results(parser, *options);
  add_model_options(parser, options->model_a, "--scale", "--up", "A");
  add_model_options(parser, options->model_b, "--scale-b", "--up-b", "B");
  parser.remove_option(parser.option("--crs"));  // places on the Earth change nothing here
  parser.remove_option(parser.option("--crs-b"));
  add_strict(parser, options->model_a.strict);
  add_trees(parser, *options);
  parser.footer(kFooter);
  return [options, &parser](Console& console) {
    settle(parser, *options);
    return run_thesis(*options, console);
  };
}

}  // namespace

Verb thesis_verb() {
  return {.name = kThesisVerb, .question = kThesisQuestion, .add = add_thesis};
}

int run_thesis(const ThesisOptions& options, Console& console) {
  check_files(options);
  ThesisTrips trips = thesis_trips(options, console);
  for (const std::string& remark : trips.remarks) {
    console.note(remark);
  }
  if (options.view) {
    return show_trip(trips.trips.front(), options, console);
  }
  const ThesisPictures pictures(options);
  const ThesisLists lists(options);
  ThesisReport report{options, run_trips(std::move(trips.trips), options, console), trips.remarks,
                      trips.warnings};
  lists.write(report);
  console.print(console.shared().json ? json_line(thesis_json(report)) : thesis_text(report));
  console.flush();
  return pictures.draw(report.results, console);
}

}  // namespace soms::command
