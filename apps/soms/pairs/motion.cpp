#include "apps/soms/pairs/motion.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/base/text.h"
#include "soms/geometry/parts_of.h"
#include "soms/motion/first_contact.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/rows/sinks.h"
#include "apps/soms/answers/batch_question.h"
#include "apps/soms/pairs/motion_page.h"
#include "apps/soms/pairs/motion_rows.h"
#include "apps/soms/pairs/motion_verify.h"
#include "apps/world/part_names.h"
#include "apps/world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

namespace soms::command {

namespace {

constexpr const char kMotionForm[] = "{:>6}  {:<22}  {:<20}  {}";

/// When does A first touch B?
class MotionQuestion : public BatchQuestion<FirstContact> {
 public:
  MotionQuestion(const MotionRows& rows, const FirstContactOptions& options, const Console& console)
      : BatchQuestion("motion", "motion"),
        rows_(rows),
        options_(options),
        console_(console),
        georeference_(rows.pair().georeference),
        parts_a_(rows.pair().a),
        parts_b_(rows.pair().b) {}

  std::uint64_t answer(const ShowProgress& show) override;

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    return console_.run("verifying", [&](const Limits& limits) {
      return motion_difference(
          {rows_.mover(), rows_.block()[k], rows_.fixed().shape,
           rows_.way_of_b().value_or(RigidMotion::along(rows_.fixed().pose, {}))},
          at(k), options_, limits);
    });
  }

  void count(const AnsweredRow& row) override;

  [[nodiscard]] std::string sentence(std::size_t k) const override {
    const FirstContact answer = shown(k);
    return painted(in_words(answer) + pair_text(answer) + "\n", outcome(k));
  }

  [[nodiscard]] std::string text_head() const override {
    return table_line(
        fmt::format(kMotionForm, "motion", "first contact", "triangle of A", "triangle of B"));
  }

  [[nodiscard]] std::string text(const AnsweredRow& row) const override;
  [[nodiscard]] std::string totals(const RowTotals& totals) const override;

  void begin_columns(NpzFile& file) override {
    BatchQuestion::begin_columns(file);
    add_georeference(file, rows_.pair().georeference);
  }

  void begin_page() override {
    const PairReport& pair = rows_.pair();
    page_.emplace(PageModels{pair.left_a, short_name(rows_.options().a), pair.left_b,
                             short_name(rows_.options().b)},
                  rows_.fixed().pose);
  }

  void add_to_page(const AnsweredRow& row) override;
  void write_page(std::ostream& out, const RowTotals& totals) const override;

 private:
  /// What may be a contact is one.
  [[nodiscard]] bool found(const FirstContact& answer) const override {
    return answer.verdict != ContactVerdict::free && !undecided(answer);
  }

  [[nodiscard]] bool undecided(const FirstContact& answer) const override {
    return answer.coverage == Coverage::cut && answer.verdict == ContactVerdict::grazing;
  }

  [[nodiscard]] const FileNumbers& numbers(int side) const override {
    return (side == 0 ? rows_.pair().left_a : rows_.pair().left_b).numbers;
  }

  [[nodiscard]] std::string row_keys(const AnsweredRow& row) const override {
    return report_keys(rows_.pair(), row.number, row.right);
  }

  [[nodiscard]] std::string more_head() const override { return std::string(georeference_.head()); }

  [[nodiscard]] std::string more_cells(std::size_t /*k*/) const override {
    return std::string(georeference_.field());
  }

  [[nodiscard]] std::string triangle_cells(int side,
                                           std::optional<TriangleId> triangle) const override {
    return side == 0 ? triangle_csv_fields(rows_.pair().a, parts_a_, triangle)
                     : triangle_csv_fields(rows_.pair().b, parts_b_, triangle);
  }

  /// "contact", or "within 0.5".
  [[nodiscard]] std::string event() const {
    return options_.within == 0 ? "contact" : "place within " + readable(options_.within);
  }

  void answer_of_two(const std::vector<RigidMotion>& motions, const Limits& limits);
  [[nodiscard]] std::string in_words(const FirstContact& answer) const;
  [[nodiscard]] bool next_touch(const FirstContact& answer) const;
  [[nodiscard]] std::string next_in_words(const FirstContact& answer) const;
  [[nodiscard]] std::string pair_text(const FirstContact& answer) const;
  [[nodiscard]] std::string cell(const FirstContact& answer) const;
  [[nodiscard]] std::string way_in_words(const FirstContact& answer) const;
  [[nodiscard]] std::string label(const FirstContact& answer, int side) const;

  const MotionRows& rows_;
  FirstContactOptions options_;
  const Console& console_;
  GeoreferenceColumn georeference_;
  PartsOf parts_a_;
  PartsOf parts_b_;
  std::optional<std::uint64_t> first_;  ///< motion that is not free
  std::string first_cell_;
  std::optional<MotionPage> page_;
};

/// Where B moves, too, each motion of A is a question of its own.
void MotionQuestion::answer_of_two(const std::vector<RigidMotion>& motions, const Limits& limits) {
  for_each_chunk(motions.size(), 1, limits.without_deadline(), [&](std::size_t k, std::size_t) {
    put(k, first_contact(rows_.mover(), motions[k], rows_.fixed().shape, *rows_.way_of_b(),
                         options_, limits.alone()));
  });
}

std::uint64_t MotionQuestion::answer(const ShowProgress& show) {
  const std::vector<RigidMotion>& motions = rows_.block();
  reserve(motions.size());
  Limits limits = console_.limits();
  limits.progress = show;
  try {
    if (rows_.way_of_b()) {
      answer_of_two(motions, limits);
    } else {
      put(0, first_contact(rows_.mover(), motions, rows_.fixed(), options_, limits));
    }
  } catch (const Error& error) {
    if (rows_.before() == 0 || error.kind() == ErrorKind::cancelled) {
      throw;
    }
    throw Error(error.kind(),
                fmt::format("of the motions from {} on, {}", rows_.before(), error.place()),
                error.remedy());
  }
  return 0;
}

void MotionQuestion::count(const AnsweredRow& row) {
  const FirstContact answer = at(row.k);
  if (!first_ && found(answer)) {
    first_ = row.number;
    first_cell_ = cell(answer);
  }
}

std::string MotionQuestion::in_words(const FirstContact& answer) const {
  if (undecided(answer)) {
    return fmt::format("undecided, out of time: no {} until t = {}", event(),
                       readable(answer.t.lower));
  }
  switch (answer.verdict) {
    case ContactVerdict::free:
      return fmt::format("free: no {} on the way", event());
    case ContactVerdict::contact:
      return fmt::format("first {} at t = {}", event(), readable(answer.t.upper));
    case ContactVerdict::started:
      return options_.within == 0
                 ? "in contact at the start" + next_in_words(answer)
                 : fmt::format("within {} at the start", readable(options_.within));
    case ContactVerdict::grazing:
      break;
  }
  return fmt::format("grazing: no {} until t = {}, and then nearer to one than rounding can tell",
                     event(), readable(answer.t.lower));
}

/// With --parting: a contact after the start.
bool MotionQuestion::next_touch(const FirstContact& answer) const {
  return options_.parting && answer.t.upper <= 1;
}

std::string MotionQuestion::next_in_words(const FirstContact& answer) const {
  if (!options_.parting) {
    return "";
  }
  if (next_touch(answer)) {
    return "; the next one at t = " + readable(answer.t.upper);
  }
  return answer.t.lower == 1 ? "; no other on the way"
                             : "; no other until t = " + readable(answer.t.lower);
}

std::string MotionQuestion::pair_text(const FirstContact& answer) const {
  if (!answer.triangles) {
    return "";
  }
  const PairReport& pair = rows_.pair();
  return fmt::format(": triangle {} of {} and triangle {} of {} at {}",
                     triangle_label(pair.a, answer.triangles->a), printable(pair.a.source),
                     triangle_label(pair.b, answer.triangles->b), printable(pair.b.source),
                     point_in_text(answer.point));
}

std::string MotionQuestion::cell(const FirstContact& answer) const {
  if (undecided(answer)) {
    return "undecided";
  }
  switch (answer.verdict) {
    case ContactVerdict::free:
      return "free";
    case ContactVerdict::contact:
      return "t = " + readable(answer.t.upper, digits());
    case ContactVerdict::started:
      return next_touch(answer) ? "at the start, t = " + readable(answer.t.upper, digits())
                                : "at the start";
    case ContactVerdict::grazing:
      break;
  }
  return "grazing, t = " + readable(answer.t.lower, digits());
}

/// The triangle of A or B; empty where none is named.
std::string MotionQuestion::label(const FirstContact& answer, int side) const {
  if (!answer.triangles) {
    return "";
  }
  return side == 0 ? triangle_label(rows_.pair().a, answer.triangles->a)
                   : triangle_label(rows_.pair().b, answer.triangles->b);
}

std::string MotionQuestion::text(const AnsweredRow& row) const {
  const FirstContact answer = shown(row.k);
  return table_line(
      fmt::format(kMotionForm, row.number, cell(answer), label(answer, 0), label(answer, 1)));
}

/// What A is: free until when, and who meets whom.
std::string MotionQuestion::way_in_words(const FirstContact& answer) const {
  const std::string lower = readable(answer.t.lower);
  const std::string upper = readable(answer.t.upper);
  const bool touching = options_.within == 0;
  const std::string reached = touching ? "in contact" : "within " + readable(options_.within);
  const std::string pair =
      answer.triangles ? fmt::format("; triangle {} of A {} triangle {} of B", label(answer, 0),
                                     touching ? "meets" : "is near", label(answer, 1))
                       : "";
  if (undecided(answer)) {
    return fmt::format("free until {} of the way, and undecided from there on: out of time", lower);
  }
  switch (answer.verdict) {
    case ContactVerdict::free:
      return touching ? "free all the way" : fmt::format("never {} on the way", reached);
    case ContactVerdict::contact:
      return fmt::format("free until {} of the way, and {} {}{}", lower, reached,
                         lower == upper ? "there" : "by " + upper, pair);
    case ContactVerdict::started:
      return reached + " at the start" + next_in_words(answer) + pair;
    case ContactVerdict::grazing:
      break;
  }
  return fmt::format("free until {} of the way, and then too near to tell", lower);
}

void MotionQuestion::add_to_page(const AnsweredRow& row) {
  const FirstContact answer = shown(row.k);
  page_->add(rows_.block()[row.k], at(row.k),
             {.verdict = cell(answer),
              .sentence = way_in_words(answer),
              .triangle_a = label(answer, 0),
              .triangle_b = label(answer, 1)});
}

void MotionQuestion::write_page(std::ostream& out, const RowTotals& totals) const {
  page_->write(out, rows_.pair(), totals);
}

std::string MotionQuestion::totals(const RowTotals& totals) const {
  return fmt::format(
      "{}: {} free, {} with {}{}{}\n", counted(totals.rows, "motion"),
      with_commas(totals.rows - totals.found - totals.undecided), with_commas(totals.found),
      options_.within == 0 ? "contact" : "a " + event(),
      first_ ? fmt::format(" (the first in motion {}, {})", *first_, first_cell_) : "",
      totals.undecided == 0 ? "" : fmt::format(", {} undecided", with_commas(totals.undecided)));
}

void check_motion_options(const MotionVerbOptions& options) {
  const int given = (options.to ? 1 : 0) + (options.by ? 1 : 0) + (options.path ? 1 : 0);
  if (given != 1) {
    throw Error(ErrorKind::usage,
                given == 0 ? "neither --to, --by nor --path is given"
                           : "--to, --by and --path exclude each other",
                "give one of them");
  }
  if (options.path && options.from) {
    throw Error(ErrorKind::usage, "--path and --from exclude each other",
                "begin the path with the first pose");
  }
  if (options.by && options.pivot) {
    throw Error(ErrorKind::usage, "--pivot has no effect with --by, which turns nothing",
                "leave it out, or give --to");
  }
  const std::array<std::optional<std::string>, 7> inputs{
      options.a, options.b, options.pose_b, options.from, options.to, options.path, options.to_b};
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  if (options.parting && options.clearance > 0) {
    throw Error(ErrorKind::usage, "--parting and --clearance exclude each other",
                "leave one of them out");
  }
  if (options.to_b && !options.outputs.page.empty()) {
    throw Error(ErrorKind::usage, "-o FILE.html: a page shows one model that moves",
                "leave it out, or --to-b");
  }
  check_answer_outputs({{"A", options.a},
                        {"B", options.b},
                        {"--from", options.from.value_or("")},
                        {"--to", options.to.value_or("")},
                        {"--path", options.path.value_or("")},
                        {"--pose-b", options.pose_b.value_or("")},
                        {"--to-b", options.to_b.value_or("")}},
                       options.outputs);
}

void add_vector(Parser& parser, const char* name, std::optional<Vec3>& target,
                const std::string& meaning) {
  parser
      .add_option_function(
          name, [name, &target](const std::string& text) { target = parse_point(name, text); },
          meaning)
      ->option_text("X,Y,Z")
      ->group(kQuestionGroup);
}

void add_motion_poses(Parser& parser, MotionVerbOptions& options) {
  const auto pose = [&](const char* name, std::optional<std::string>& target,
                        const std::string& meaning, const char* form) {
    parser.add_option(name, target, meaning)->option_text(form)->group(kQuestionGroup);
  };
  pose("--from", options.from, "pose of A at the start: \"x y z [qw qx qy qz]\", or rows of a file",
       "POSE");
  pose("--to", options.to, "pose of A at the end, in the same form", "POSE");
  add_vector(parser, "--by", options.by, "a straight shift from --from on, in place of --to");
  pose("--path", options.path, "poses of A, row per pose: a motion from each to the next", "FILE");
  add_vector(parser, "--pivot", options.pivot,
             "the point of A that goes straight; else its origin");
  pose("--pose-b", options.pose_b, "the pose at which B rests, or starts", "POSE");
  pose("--to-b", options.to_b, "pose of B at the end: both move at the same time", "POSE");
}

}  // namespace

Action add_motion(Parser& parser, Shared&) {
  const auto options = std::make_shared<MotionVerbOptions>();
  parser.add_option("A", options->a, "model that moves; - is standard input")->required();
  parser.add_option("B", options->b, "model that rests, or with --to-b moves, too")->required();
  add_motion_poses(parser, *options);
  add_length(parser, "--clearance", options->clearance, "being this near is a contact")
      ->group(kQuestionGroup);
  parser
      .add_flag("--parting", options->parting,
                "leave out pairs of triangles in contact at the start: what touches may slide")
      ->group(kQuestionGroup);
  add_verify(parser, *options);
  add_choice<bool>(parser, "--fail-if", options->fail_if_contact, {{"contact", true}},
                   "exit with status 1 unless all is free")
      ->group(kQuestionGroup);
  add_renamed_outputs(
      parser, options->outputs,
      {AnswerFile::csv, AnswerFile::npz, AnswerFile::json, AnswerFile::lines, AnswerFile::page},
      kQuestionGroup);
  add_model_reading(parser, *options);
  parser.footer(
      "The first contact of the surfaces, proved for all times t of the way, from 0 to 1. A turns\n"
      "about the pivot while that goes straight. Straight shifts are decided exactly." +
      example_of_pair("motion knot.ply ball.off --from \"9 0 0\" --by \"-9 0 0\""));
  return [options, &parser](Console& console) {
    settle(parser, *options);
    check_motion_options(*options);
    return run_motion(*options, console);
  };
}

int run_motion(const MotionVerbOptions& options, Console& console) {
  Sinks sinks(options.outputs, console);
  MotionRows rows(options, console);
  MotionQuestion question(rows, {.within = options.clearance, .parting = options.parting}, console);
  return RowRun({.verb = "motion",
                 .noun = "motion",
                 .verify = options.verify,
                 .fail_if_found = options.fail_if_contact},
                rows, question, sinks, console)
      .run();
}

}  // namespace soms::command
