#include "apps/soms/clearance/clearance.h"

#include "soms/base/error.h"
#include "soms/scene/reference/clearance_along.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/length_unit.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/rows/answer_outputs.h"
#include "apps/rows/json_list.h"
#include "apps/soms/clearance/clearance_map.h"
#include "apps/soms/clearance/clearance_output.h"
#include "apps/soms/clearance/clearance_page.h"
#include "apps/soms/clearance/clearance_path.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/world/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <utility>

namespace soms::command {

namespace {

/// Parts of the diagonal of the profile's box that are the usual distance of stations, and the
/// usual accuracy.
constexpr double kStationsADiagonal = 10;
constexpr double kAccuraciesADiagonal = 500;
/// Places between two stations that --verify looks at.
constexpr std::size_t kVerifiedAStretch = 3;

/// A round part of the size of the profile.
double part_of_size(const Model& profile, double parts) {
  const double size = std::hypot(2 * profile.ground_radius, profile.height);
  return size > 0 ? round_length(size / parts) : 1 / parts;
}

ClearanceOptions search_options(const ClearanceVerbOptions& options, const Model& profile) {
  return {.every = options.every.value_or(part_of_size(profile, kStationsADiagonal)),
          .accuracy = options.accuracy.value_or(part_of_size(profile, kAccuraciesADiagonal)),
          .clearance = options.clearance,
          .keep_on_stop = true};
}

std::vector<OutputKind> clearance_files(ClearanceVerbOptions& options) {
  return {{{".csv"}, &options.table, ".csv"},
          {{".json"}, &options.list, ".json"},
          {{".jsonl"}, &options.lines, ".jsonl (lines)"},
          {{".svg"}, &options.map, ".svg (a map)", "--map"},
          {{".html", ".htm"}, &options.report, ".html (a page)", "--report"}};
}

/// Files of answers, opened before the work.
class ClearanceFiles {
 public:
  explicit ClearanceFiles(const ClearanceVerbOptions& options) {
    open(options.table, [](std::ostream& out, const auto& report, const auto& names) {
      out << clearance_as_csv(report, names);
    });
    for (const std::string& name : {options.list, options.lines}) {
      open(name, [name](std::ostream& out, const auto& report, const auto& names) {
        JsonListWriter list(out, name);
        write_clearance_as_json(report, names, list);
      });
    }
    open(options.map, draw_clearance_map);
    open(options.report, write_clearance_page);
  }

  void write(const ClearanceReport& report, const NearestNames& names) {
    for (const auto& [file, form] : files_) {
      form(file->stream(), report, names);
      file->commit();
    }
  }

 private:
  using Form =
      std::function<void(std::ostream&, const ClearanceReport& report, const NearestNames& names)>;

  void open(const std::string& name, Form form) {
    if (!name.empty()) {
      files_.emplace_back(std::make_unique<OutputFile>(name), std::move(form));
    }
  }

  std::vector<std::pair<std::unique_ptr<OutputFile>, Form>> files_;
};

void check_clearance_files(const ClearanceVerbOptions& options) {
  NamedFiles taken{{"--profile", options.profile}, {"--path", options.path}};
  for (const std::string& city : options.world.cities) {
    taken.emplace_back("CITY", city);
  }
  ClearanceVerbOptions named = options;
  check_outputs_by_extension(std::move(taken), clearance_files(named));
  if (options.fail_if == ClearanceFailure::below && !(options.clearance > 0)) {
    throw Error(ErrorKind::usage, "--fail-if below has no effect without --clearance",
                "also give --clearance D");
  }
}

/// A vehicle that is longer across its path than along it is rarely meant.
void note_forward(const World& world, Forward forward, const Console& console) {
  const Vec3 extent = world.models.front().shape.bounds().extent();
  const bool along_x = forward == Forward::x || forward == Forward::minus_x;
  const double along = along_x ? extent.x : extent.y;
  const double across = along_x ? extent.y : extent.x;
  if (world.routes.front().recorded == nullptr && across > 1.2 * along) {
    console.note(
        fmt::format("{}: {:.4g} across the path and {:.4g} along it; --forward names the "
                    "axis that heads along",
                    world.models.front().origin.source, across, along));
  }
}

Clearance move_along(const World& world, const ProfilePath& path, const ClearanceOptions& options,
                     const Console& console) {
  Progress bar = console.progress("moving along the path");
  Limits limits = console.limited();
  limits.progress = [&bar](double share) { bar.show(share); };
  return clearance_along(world.models.front().shape, path.motion, world.city, options, limits);
}

/// True if brute force agrees. \errors ErrorKind::timed_out.
bool agrees_with_brute_force(const ClearanceReport& report, const Console& console,
                             std::string& line) {
  const reference::ClearanceCheck found = console.run("verifying", [&](const Limits& limits) {
    return reference::check_clearance(report.answer, report.profile().shape, report.path.motion,
                                      report.world.city, report.options, kVerifiedAStretch, limits);
  });
  if (found.wrong > 0) {
    print_error("soms clearance", "brute force: " + found.first);
  }
  line = fmt::format("verified by brute force: {}, {} wrong\n", counted(found.places, "place"),
                     with_commas(found.wrong));
  return found.wrong == 0;
}

int status_of(const ClearanceVerbOptions& options, const ClearanceReport& report, bool wrong) {
  if (wrong) {
    return kDifference;
  }
  if (report.interrupted) {
    return kInterrupted;
  }
  if (options.fail_if == ClearanceFailure::never) {
    return 0;
  }
  const ClearanceVerdict verdict = report.verdict();
  if (verdict == ClearanceVerdict::contact ||
      (options.fail_if == ClearanceFailure::below && verdict == ClearanceVerdict::below)) {
    return kConditionHolds;
  }
  // "Not found" is no proof that there is nothing.
  const bool proved = options.fail_if == ClearanceFailure::contact
                          ? report.answer.at_least > 0
                          : verdict == ClearanceVerdict::ok;
  return proved && report.answer.coverage == Coverage::complete ? 0 : kOutOfTime;
}

void add_profile_and_path(Parser& parser, ClearanceVerbOptions& options) {
  parser
      .add_option("CITY", options.world.cities,
                  "static models, in one coordinate frame; - is standard input")
      ->required()
      ->option_text("FILE...");
  parser.add_option("--profile,--mover", options.profile, "the model that moves")
      ->required()
      ->option_text("FILE");
  parser
      .add_option(
          "--path,--route", options.path,
          "its path, a CSV file of points or poses as of soms simulate; - is standard input")
      ->required()
      ->option_text("FILE");
  add_choice<Forward>(
      parser, "--forward", options.forward,
      {{"x", Forward::x}, {"y", Forward::y}, {"-x", Forward::minus_x}, {"-y", Forward::minus_y}},
      "axis of the profile that heads along the path (x)");
  add_model_options(parser, options.world.city_model, "--scale", "--up", "the city");
  add_model_options(parser, options.world.mover_model, "--mover-scale", "--mover-up",
                    "the profile");
  add_part_filter(parser, options.world.city_model.parts, "the city");
  parser
      .add_flag_callback(
          "--strict",
          [&options] { options.world.city_model.strict = options.world.mover_model.strict = true; },
          kStrictMeaning)
      ->group("Models");
}

void add_clearance_questions(Parser& parser, ClearanceVerbOptions& options) {
  const auto add_optional = [&](const std::string& name, std::optional<double>& target,
                                const std::string& text) {
    parser
        .add_option_function(
            name,
            [name, &target](const std::string& value) {
              target = parse_number(name, value);
              if (!(*target > 0)) {
                throw Error(ErrorKind::usage, name + " " + value + " is not above 0",
                            "give a number above 0");
              }
            },
            text)
        ->option_text("D")
        ->group(kQuestionGroup);
  };
  add_optional("--every", options.every,
               "length of the path from one station to the next (about a tenth of the\nprofile's "
               "diagonal); each row of the path is a station, too");
  add_optional("--accuracy", options.accuracy,
               "how well least gaps are known between stations (about a 500th of the\ndiagonal)");
  add_positive(parser, "--clearance", options.clearance,
               "the clearance that is required: stations and stretches are ok, below,\ncontact or "
               "undecided")
      ->option_text("D")
      ->group(kQuestionGroup);
  add_choice<ClearanceFailure>(
      parser, "--fail-if", options.fail_if,
      {{"contact", ClearanceFailure::contact}, {"below", ClearanceFailure::below}},
      "exit with status 1 if anything touches, or is nearer than the\n--clearance")
      ->group(kQuestionGroup);
  parser
      .add_flag("--verify", options.verify,
                "compare stations, and places between them, with brute force; exit with\nstatus 6 "
                "if they differ")
      ->group(kQuestionGroup);
  add_outputs(parser, clearance_files(options), "Options",
              "write the stations, or a picture of the path, to a file, by its extension; may be\n"
              "repeated: ");
}

}  // namespace

Action add_clearance(Parser& parser, Shared&) {
  const auto options = std::make_shared<ClearanceVerbOptions>();
  add_profile_and_path(parser, *options);
  add_clearance_questions(parser, *options);
  parser.footer(
      "A path is a CSV file. x,y,z: points of a line that the foot of the profile (the middle of\n"
      "the underside of its box) is on, with +x (or --forward) heading along; it turns on the\n"
      "spot where lines meet, a half turn to the left. With qw,qx,qy,qz, or as r00,...,tz: poses,\n"
      "each reached by a straight line of the origin and a turn about it. Gaps at stations are\n"
      "exact; what is proved of the motion between is said beside. Only surfaces are compared.\n\n"
      "Example:\n"
      "  soms generate city --triangles 20000 -o town.ply\n"
      "  soms generate car -o car.ply\n"
      "  printf 'x,y,z\\n-60,-2,0.5\\n60,-2,0.5\\n' |\n"
      "    soms clearance town.ply --profile car.ply --path - --clearance 0.5 -o path.svg");
  return [options](Console& console) { return run_clearance(*options, console); };
}

int run_clearance(const ClearanceVerbOptions& options, Console& console) {
  check_clearance_files(options);
  ClearanceFiles files(options);
  console.go_on_without_reader();
  WorldOptions wanted = options.world;
  wanted.movers = {options.profile};
  wanted.routes = {options.path};
  const World world = load_world(wanted, console);
  note_forward(world, options.forward, console);
  const ProfilePath path =
      profile_path(world.routes.front(), world.models.front().foot, options.forward);
  const ClearanceOptions search = search_options(options, world.models.front());
  ClearanceReport report{.world = world,
                         .path = path,
                         .options = search,
                         .answer = move_along(world, path, search, console),
                         .path_file = options.path,
                         .only = wanted.city_model.parts->patterns(true),
                         .ignored = wanted.city_model.parts->patterns(false),
                         .unit = common_unit(world.city)};
  const bool cut = report.answer.coverage == Coverage::cut;
  report.interrupted = cut && console.interrupted();
  report.timed_out = cut && !report.interrupted;
  if (report.timed_out) {
    console.note(
        fmt::format("out of time after {}", counted(report.answer.stations.size(), "station")));
  }
  std::string line;
  bool wrong = false;
  if (options.verify && cut) {
    console.note("not verified, as the path was not finished");
  } else if (options.verify) {
    wrong = !agrees_with_brute_force(report, console, line);
    report.verified = !wrong;
  }
  const NearestNames names(world);
  if (console.shared().json) {
    std::ostringstream text;
    JsonListWriter list(text, {});
    write_clearance_as_json(report, names, list);
    console.print(text.str());
  } else {
    console.print(clearance_in_text(report, names) + line);
  }
  console.flush();
  files.write(report, names);
  return status_of(options, report, wrong);
}

}  // namespace soms::command
