#include "apps/soms/pairs/overlap.h"

#include "soms/query/reference/overlap.h"
#include "soms/tiles/tiled_queries.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/shards/shard_files.h"
#include "apps/soms/answers/answer_columns.h"
#include "apps/soms/pairs/overlap_output.h"
#include "apps/soms/pairs/overlap_report.h"
#include "apps/soms/pairs/overlap_verify.h"
#include "apps/soms/pairs/pose_run.h"
#include "apps/soms/pairs/within.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace soms::command {

namespace {

std::vector<RefusedOfTiles> refused_of_tiles(const OverlapVerbOptions& options) {
  return {{!options.report.empty(), "--report", "a page shows the whole model"},
          {options.by_part, "--by part", "a part may lie in several of them"},
          {options.query.limit != OverlapOptions().limit, "--limit",
           "the first pairs are not known before all are found"},
          {options.traversal->named(), "a traversal by name",
           "it needs the binary tree of the whole model"}};
}

/// Which triangles overlap, pose by pose.
class OverlapPoses : public PoseRun {
 public:
  OverlapPoses(const OverlapVerbOptions& options, OverlapOutput& output, Console& console)
      : PoseRun(options,
                {.verb = "overlap",
                 .fail_if_found = !options.fail_if.empty(),
                 .has_files =
                     !options.csv.empty() || !options.binary.empty() || !options.report.empty(),
                 .keep_trees = options.traversal->named(),
                 .is_free = options.query.mode == OverlapMode::any,
                 .refused_of_tiles = refused_of_tiles(options)},
                console),
        query_(options.query),
        traversal_(*options.traversal),
        output_(output),
        report_{.pair = report(),
                .mode = query_.mode,
                .list_pairs = options.list_pairs,
                .by_part = options.by_part} {
    query_.deadline = console.deadline();
    output_.begin(report_);
  }

 private:
  void reserve(std::size_t rows) override { answers_.assign(rows, {}); }

  void ask(std::size_t k, const Body& a, const Body& b, const Parallel& parallel) override {
    if (traversal_.named()) {
      answers_[k] = traversal_.overlap(a, b, query_, parallel);
    } else {
      answers_[k].answer = soms::overlap(a, b, query_, parallel);
    }
  }

  void ask(std::size_t begin, const Shape& a, std::span<const Pose> poses, const Body& b,
           const Parallel& parallel) override {
    if (traversal_.named()) {
      std::vector<CountedAnswer> answers = traversal_.overlap(a, poses, b, query_, parallel);
      std::move(answers.begin(), answers.end(),
                answers_.begin() + static_cast<std::ptrdiff_t>(begin));
      return;
    }
    const OverlapBatch batch = soms::overlap(a, poses, b, query_, parallel);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_[begin + k].answer = batch.at(k);
    }
  }

  void ask_tiles(std::size_t begin, const Shape& a, std::span<const Pose> poses, const TiledBody& b,
                 const Parallel& parallel) override {
    const OverlapBatch batch = soms::overlap(a, poses, b, query_, parallel);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      answers_[begin + k].answer = batch.at(k);
    }
  }

  [[nodiscard]] std::uint64_t held() const override {
    std::uint64_t pairs = 0;
    for (const CountedAnswer& counted : answers_) {
      pairs += counted.answer.pairs.size();
    }
    return pairs;
  }

  [[nodiscard]] Outcome outcome(std::size_t k) const override {
    const Overlap& answer = answers_[k].answer;
    return {.found = answer.any,
            .undecided = is_undecided(answer),
            .cut = answer.coverage == Coverage::cut && answer.pairs.size() < query_.limit};
  }

  [[nodiscard]] std::optional<std::string> difference(std::size_t k) override {
    const Overlap truth = console().run("verifying", [&](const Parallel& parallel) {
      return reference::overlap(report().a, pose_a(k), report().b, pose_b(k), parallel);
    });
    if (agrees(answers_[k].answer, truth, query_.mode)) {
      return std::nullopt;
    }
    return fmt::format("brute force finds {}, but the answer has {}",
                       counted(truth.pairs.size(), "pair"), answers_[k].answer.pairs.size());
  }

  void print_answer(std::size_t k, bool right) override {
    output_.add(number(), pose_a(k), pose_b(k), answers_[k], right, console());
  }

  void print_totals() override { command::print_totals(report_, totals(), console()); }

  void finish_outputs() override { output_.finish(totals()); }

  OverlapOptions query_;
  const TraversalByName& traversal_;
  OverlapOutput& output_;
  OverlapReport report_;
  std::vector<CountedAnswer> answers_;
};

void add_questions(Parser& parser, OverlapVerbOptions& options) {
  const char* const group = kQuestionGroup;
  OverlapMode& mode = options.query.mode;
  const auto asks = [&](const std::string& name, OverlapMode value, const std::string& text) {
    return parser
        .add_flag_callback(
            name, [&mode, value] { mode = value; }, text)
        ->group(group);
  };
  Option* all = asks("--all", OverlapMode::all, "find every pair (default)");
  Option* any = asks("--any", OverlapMode::any, "stop at the first pair found, whichever it is");
  Option* first = asks("--first", OverlapMode::first, "find the lowest pair by triangle numbers");
  any->excludes(all)->excludes(first);
  first->excludes(all);
  add_count(parser, "--limit", options.query.limit, 1, std::numeric_limits<std::uint64_t>::max(),
            "stop after N pairs per pose")
      ->excludes(any)
      ->excludes(first)
      ->group(group);
  Option* no_pairs = parser
                         .add_flag_callback(
                             "--no-pairs", [&options] { options.list_pairs = false; },
                             "count the pairs without listing them")
                         ->group(group);
  add_choice<bool>(parser, "--by", options.by_part, {{"triangle", false}, {"part", true}},
                   "what to list pairs of")
      ->excludes(any)
      ->excludes(first)
      ->excludes(no_pairs)
      ->group(group);
  add_choice<std::string>(parser, "--fail-if", options.fail_if,
                          {{"overlap", "overlap"}, {"within", "within"}},
                          "exit with status 1 if this is found")
      ->group(group);
  add_output(parser, "--report", options.report,
             "write an HTML report with figures, plots and a 3-D view of the overlap")
      ->group(group);
  add_output(parser, "--csv", options.csv, "write the pairs as CSV, one row per pair")
      ->excludes(no_pairs)
      ->group(group);
  add_binary(parser, options.binary);
  add_shard(parser, options, kQuestionGroup);
  add_length(
      parser, "--within", options.within,
      "only decide whether they are within D, as soms within does; not with options of pairs")
      ->group(group);
  add_verify(parser, options);
}

/// \errors ErrorKind::usage for a condition that is not part of the question.
void check_condition(const std::string& condition, bool within) {
  if (within && condition == "overlap") {
    throw Error(ErrorKind::usage, "--fail-if overlap has no effect with --within",
                "give --fail-if within, or leave --within out");
  }
  if (!within && condition == "within") {
    throw Error(ErrorKind::usage, "--fail-if within has no effect without --within",
                "also give --within D");
  }
}

/// The question, for receipts of shards.
Json terms_of(const OverlapVerbOptions& options) {
  constexpr std::array<const char*, 3> kModes{"all", "any", "first"};
  Json question{{"verb", "overlap"},
                {"mode", kModes[static_cast<std::size_t>(options.query.mode)]},
                {"pairs", options.list_pairs}};
  if (options.by_part) {
    question["by"] = "part";
  }
  if (options.query.limit != OverlapOptions().limit) {
    question["limit"] = options.query.limit;
  }
  if (options.traversal->named()) {
    question["traversal"] = options.traversal->text();
  }
  return question;
}

/// The question of `soms within`.
int run_within_of(const Parser& parser, const OverlapVerbOptions& options, Console& console) {
  for (const char* const idle :
       {"--all", "--any", "--first", "--limit", "--no-pairs", "--by", "--traversal", "--descent"}) {
    if (parser.count(idle) > 0) {
      throw Error(ErrorKind::usage, fmt::format("{} has no effect with --within", idle),
                  "leave one of them out");
    }
  }
  WithinVerbOptions within;
  static_cast<PairOptions&>(within) = options;
  within.verb = "overlap";
  within.clearance = options.within;
  within.fail_if_within = !options.fail_if.empty();
  within.csv = options.csv;
  within.binary = options.binary;
  within.report = options.report;
  return run_within(within, console);
}

}  // namespace

Action add_overlap(Parser& parser, Shared&) {
  const auto options = std::make_shared<OverlapVerbOptions>();
  add_posed_models(parser, *options);
  add_questions(parser, *options);
  add_model_reading(parser, *options);
  options->traversal = add_traversal_by_name(parser);
  parser.footer(
      "Touching counts as overlap: corners and edges belong to their triangles. Only surfaces are\n"
      "tested: a body entirely inside another one does not overlap it." +
      example_of_pair("overlap knot.ply ball.off --pose \"0.5 0 0\""));
  return [options, &parser](Console& console) {
    settle(parser, *options);
    const bool within = parser.count("--within") > 0;
    check_condition(options->fail_if, within);
    if (within) {
      return run_within_of(parser, *options, console);
    }
    options->traversal->check(parser);
    if (!options->list_pairs && options->query.mode != OverlapMode::all && !console.shared().json &&
        options->binary.empty()) {
      throw Error(ErrorKind::usage,
                  "--no-pairs has no effect: --any and --first list no pairs without --json",
                  "leave it out, or also give --json or --binary");
    }
    return run_overlap(*options, console);
  };
}

int run_overlap(const OverlapVerbOptions& given, Console& console) {
  OverlapVerbOptions options = given;
  if (!begin_shard(options, terms_of(options),
                   {options.csv, options.binary, options.report, !options.fail_if.empty()},
                   console)) {
    return 0;
  }
  check_files(options,
              {{"--report", options.report}, {"--csv", options.csv}, {"--binary", options.binary}});
  check_extension("--report", options.report, {".html", ".htm"});
  check_extension("--csv", options.csv, {".csv"});
  check_extension("--binary", options.binary, {".npz"});
  OverlapOutput output(options);
  return OverlapPoses(options, output, console).run();
}

}  // namespace soms::command
