#include "apps/soms/robot/robot.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/robot/reference/robot_query.h"
#include "soms/robot/robot_path.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/rows/csv_file.h"
#include "apps/rows/row_run.h"
#include "apps/rows/sinks.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/robot/robot_output.h"
#include "apps/soms/robot/robot_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace soms::command {

namespace {

constexpr std::uint64_t kMostRandom = 1'000'000'000;

/// States of a robot, and what they touch.
class RobotQuestion : public Rows, public Question {
 public:
  RobotQuestion(const RobotVerbOptions& options, RobotModels models, Console& console)
      : options_(options),
        models_(std::move(models)),
        console_(console),
        states_(options, models_, console),
        report_{.models = models_, .distance = options.distance} {
    if (options.path) {
      report_.path.emplace();
    }
    for (const RobotBody& body : models_.model.cell_bodies()) {
      cell_box_.grow(body.part.body.shape.bounds());
    }
  }

  void begin() override {
    if (!console_.shared().json) {
      console_.print(models_in_text(models_));
    }
  }

  void clear() override {
    block_.clear();
    boxes_.clear();
    twins_.clear();
  }

  bool ready() override { return states_.ready(); }

  bool read() override {
    const auto state = states_.next();
    if (!state) {
      return false;
    }
    block_.insert(block_.end(), state->begin(), state->end());
    boxes_.push_back(states_.box());
    return true;
  }

  std::uint64_t answer(const ShowProgress&) override {
    answers_.clear();
    ways_.assign(boxes_.size(), std::nullopt);
    if (boxes_.empty()) {
      return 0;
    }
    const RobotOptions query{
        .first_contact = options_.any, .distance = options_.distance, .at_most = options_.at_most};
    if (options_.path) {
      follow(query);
    } else {
      answers_ = robot_contacts(models_.model, block_, query, console_.limits());
    }
    // Without movable joints, rows are empty, and all the same.
    answers_.resize(boxes_.size(), answers_.front());
    return 0;
  }

  [[nodiscard]] RowOutcome outcome(std::size_t k) const override {
    const RobotAnswer& state = answers_[k];
    const std::optional<RobotSegment>& way = ways_[k];
    const bool found = state.verdict == RobotVerdict::contact || (way && touches(*way));
    return {
        .found = found,
        .undecided = !found && (state.verdict == RobotVerdict::undecided || (way && is_open(*way))),
        .cut = state.coverage == Coverage::cut || (way && way->coverage == Coverage::cut)};
  }

  /// The twins of a block are found together, so that threads share them.
  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    if (twins_.empty()) {
      std::vector<RobotAnswer> twins(boxes_.size());
      const std::size_t width = models_.model.kinematics().size();
      console_.run("verifying", [&](const Limits& limits) {
        for_each_chunk(twins.size(), 1, limits, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            twins[i] = reference::robot_contacts_by_brute_force(
                models_.model, std::span(block_).subspan(i * width, width), options_.distance,
                {.stop = limits.stop});
          }
        });
      });
      twins_ = std::move(twins);
    }
    if (reference::agrees(answers_[k], twins_[k])) {
      return std::nullopt;
    }
    return "brute force finds: " + answer_in_text(models_, reported_, twins_[k]);
  }

  void report(const AnsweredRow& row) override {
    boxes_watched_.look(boxes_[row.k], cell_box_);
    report_.totals.add(answers_[row.k]);
    if (report_.path) {
      report_.path->add(row.number, answers_[row.k]);
      if (const auto way = way_of(row)) {
        report_.path->add(*way);
        report_.totals.cost += way->segment.cost;
      }
    }
    report_.timed_out = report_.timed_out || row.last;
    all_right_ = all_right_ && row.right;
    ++reported_;
  }

  void json(const AnsweredRow& row, JsonRows& rows) const override {
    Json json = answer_as_json(models_, row.number, answers_[row.k],
                               options_.verify ? std::optional(row.right) : std::nullopt);
    if (const auto way = way_of(row)) {
      json["way"] = way_as_json(models_, *way);
    }
    rows.put(json_text(json));
    rows.end_row();
  }

  [[nodiscard]] Json json_totals() const override { return totals_as_json(report_); }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override {
    const auto way = way_of(row);
    return (way ? way_in_text(models_, *way) : std::string()) +
           answer_in_text(models_, row.number, answers_[row.k], terminal());
  }

  [[nodiscard]] std::string left_out(const std::string& states) const override {
    return fmt::format("and {} more; --json or -o FILE lists all\n", states);
  }

  [[nodiscard]] std::string totals(const RowTotals& /*totals*/) const override {
    return totals_in_text(report_);
  }

  [[nodiscard]] std::string csv_head() const override {
    return robot_csv_header() + (options_.path ? way_csv_header() : std::string());
  }

  void csv(const AnsweredRow& row, CsvFile& file) const override {
    file.line() += answer_as_csv(models_, row.number, answers_[row.k]);
    if (options_.path) {
      file.line() += way_as_csv(models_, way_of(row));
    }
    file.end_line();
  }

  void doubt() override {
    if (!models_.cell.empty() && boxes_watched_.always_apart()) {
      models_.warnings.push_back(
          apart_warning("the robot", "the cell", boxes_watched_.least_gap(), "at every state "));
      tell_warnings({models_.warnings.back()}, options_.reading.strict, console_);
    }
    if (const auto warning = open_warning(report_)) {
      if (options_.reading.strict) {
        throw Error(warning->kind(), "--strict: " + warning->place(), warning->remedy());
      }
      console_.note(std::string("warning: ") + warning->what());
    }
  }

  bool end(RunEnd end) override {
    report_.interrupted = end == RunEnd::interrupted;
    report_.timed_out = end == RunEnd::out_of_time;
    report_.verified = options_.verify && all_right_;
    return true;
  }

 private:
  /// The block as a path, which goes on from the last state of the block before.
  void follow(const RobotOptions& query) {
    std::vector<double> numbers = last_;
    numbers.insert(numbers.end(), block_.begin(), block_.end());
    RobotPath path = robot_path(models_.model, numbers, {.states = query}, console_.limits());
    const std::size_t before = last_.empty() ? 0 : 1;
    answers_.assign(path.states.begin() + static_cast<std::ptrdiff_t>(before), path.states.end());
    for (std::size_t k = 0; k < path.segments.size(); ++k) {
      ways_[k + 1 - before] = std::move(path.segments[k]);
    }
    const std::size_t width = models_.model.kinematics().size();
    last_.assign(block_.end() - static_cast<std::ptrdiff_t>(width), block_.end());
  }

  /// How the robot comes to a state.
  [[nodiscard]] std::optional<RobotWay> way_of(const AnsweredRow& row) const {
    return ways_[row.k] ? std::optional<RobotWay>({row.number - 1, *ways_[row.k]}) : std::nullopt;
  }

  const RobotVerbOptions& options_;
  RobotModels models_;
  Console& console_;
  RobotStates states_;
  RobotReport report_;
  std::vector<double> block_;
  std::vector<Box> boxes_;  ///< of the robot in each state of the block
  std::vector<RobotAnswer> answers_;
  std::vector<std::optional<RobotSegment>> ways_;  ///< to each state of the block
  std::vector<double> last_;                       ///< state of the block before
  std::vector<RobotAnswer> twins_;
  Box cell_box_;
  BoxWatch boxes_watched_;
  std::uint64_t reported_ = 0;  ///< rows
  bool all_right_ = true;
};

void check_options(const Parser& parser, const RobotVerbOptions& options) {
  if (options.states.empty() == (parser.count("--random") == 0)) {
    throw Error(ErrorKind::usage,
                options.states.empty() ? "no states are given"
                                       : "--states and --random both give the states",
                "give --states FILE or --random N");
  }
  if (options.states.empty() && !options.home.empty()) {
    throw Error(ErrorKind::usage, "--home has no effect without --states",
                "leave it out, or also give --states FILE");
  }
  if (parser.count("--at-most") != 0 && !options.distance) {
    throw Error(ErrorKind::usage, "--at-most has no effect without --distance",
                "leave it out, or also give --distance");
  }
  if (options.reading.parts->is_given() && options.cell.empty()) {
    throw Error(ErrorKind::usage,
                options.reading.parts->options() + " has no effect without --cell",
                "leave it out, or also give --cell FILE");
  }
  NamedFiles taken{{"ROBOT", options.urdf}, {"--srdf", options.srdf}, {"--states", options.states}};
  for (const std::string& file : options.cell) {
    taken.emplace_back("--cell", file);
  }
  check_answer_outputs(std::move(taken), options.outputs);
  if (std::count(options.cell.begin(), options.cell.end(), "-") + (options.states == "-" ? 1 : 0) >
      1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
}

void add_robot_models(Parser& parser, RobotVerbOptions& options) {
  constexpr const char* kGroup = "Robot and cell";
  parser.add_option("ROBOT", options.urdf, "the robot: a URDF file")->required();
  parser
      .add_option("--srdf", options.srdf, "SRDF file: pairs of links that may touch, named states")
      ->option_text("FILE")
      ->group(kGroup);
  add_repeatable(parser, "--package", options.packages,
                 "folder of a package, where package://NAME/ is looked for; may be repeated",
                 "NAME=DIR");
  add_repeatable(parser, "--cell", options.cell,
                 "model of the cell, in meters, compared with all links; may be repeated", "FILE");
  parser
      .add_option("--base", options.base,
                  "pose of the root link in the cell: \"x y z [qw qx qy qz]\"")
      ->option_text("POSE");
  add_repeatable(parser, "--ignore-pair", options.ignored,
                 "leave out a pair of links, besides those of the SRDF file; may be repeated",
                 "LINK,LINK")
      ->old_name("--ignore", has_comma);
  add_repeatable(parser, "--off-cell", options.off_cell,
                 "do not compare a link with the cell, such as one that stands on it; may be "
                 "repeated",
                 "LINK");
  add_positive(parser, "--round-error", options.round_error,
               "how far meshes of cylinders and spheres may exceed them, in meters (0.0005)");
  for (const char* const name :
       {"--package", "--cell", "--base", "--ignore-pair", "--off-cell", "--round-error"}) {
    parser.option(name)->group(kGroup);
  }
}

void add_robot_questions(Parser& parser, RobotVerbOptions& options) {
  parser
      .add_option(
          "--states", options.states,
          "states: CSV, with names of joints as a header or without, or .npy; - is standard "
          "input")
      ->option_text("FILE")
      ->group(kQuestionGroup);
  add_count(parser, "--random", options.random, 1, kMostRandom,
            "random states inside the joint limits, by --seed")
      ->group(kQuestionGroup);
  parser
      .add_option("--home", options.home,
                  "values of joints without a column: zero, or a named state of the SRDF file")
      ->option_text("NAME")
      ->group(kQuestionGroup);
  parser.add_flag("--any", options.any, "stop at the first contact of each state")
      ->group(kQuestionGroup);
  parser.add_flag("--distance", options.distance, "also measure how near the nearest pair is")
      ->group(kQuestionGroup);
  add_length(parser, "--at-most", options.at_most, "beyond this distance, say no more than that")
      ->option_text("D")
      ->group(kQuestionGroup);
  parser
      .add_flag("--path", options.path,
                "the states are a path: also prove what is between them, and say where it is "
                "blocked first")
      ->group(kQuestionGroup);
  add_choice<bool>(parser, "--fail-if", options.fail_if_contact, {{"contact", true}},
                   "exit with status 1 if anything touches in any state, or on the way of a path")
      ->group(kQuestionGroup);
  parser
      .add_flag("--verify", options.verify,
                "compare with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
  add_answer_outputs(parser, options.outputs,
                     {AnswerFile::csv, AnswerFile::json, AnswerFile::lines}, kQuestionGroup);
}

}  // namespace

Action add_robot(Parser& parser, Shared& shared) {
  const auto options = std::make_shared<RobotVerbOptions>();
  add_robot_models(parser, *options);
  add_robot_questions(parser, *options);
  add_model_options(parser, options->reading, "--scale", "--up", "the cell");
  add_part_filter(parser, options->reading.parts, "the cell");
  parser
      .add_flag("--strict", options->reading.strict,
                "make errors of notes, warnings, states out of limits or undecided by an open body")
      ->group("Models");
  parser.footer(
      "Exact for the poses that the joints give: surfaces that meet, and links inside of closed\n"
      "bodies. What may be inside of an open one is undecided. Without --srdf, links that a joint\n"
      "connects are not compared. Radians and meters.\n"
      "\nExample:\n"
      "  soms generate sphere --triangles 800 -o ball.off\n"
      "  printf '<robot><link name=\"a\"><collision><geometry><box size=\"1 1 1\"/></geometry>"
      "</collision></link></robot>' |\n"
      "    soms robot /dev/stdin --cell ball.off --base \"1 0 0\" --random 1");
  return [options, &parser, &shared](Console& console) {
    options->seed = shared.seed;
    check_options(parser, *options);
    return run_robot(*options, console);
  };
}

int run_robot(const RobotVerbOptions& options, Console& console) {
  RobotModels models = read_robot_models(options, console);
  Sinks sinks(options.outputs, console);
  RobotQuestion question(options, std::move(models), console);
  return RowRun({.verb = "robot",
                 .noun = "state",
                 .verify = options.verify,
                 .fail_if_found = options.fail_if_contact},
                question, question, sinks, console)
      .run();
}

}  // namespace soms::command
