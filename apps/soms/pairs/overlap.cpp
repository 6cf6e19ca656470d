#include "apps/soms/pairs/overlap.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/shards/shard_files.h"
#include "apps/soms/pairs/overlap_question.h"
#include "apps/soms/pairs/pair_question.h"
#include "apps/soms/pairs/within.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace soms::command {

namespace {

std::vector<RefusedOfTiles> refused_of_tiles(const OverlapVerbOptions& options) {
  return {refused_page(options.outputs),
          {options.by_part, "--by part", "a part may lie in several of them"},
          {options.query.limit != OverlapOptions().limit, "--limit",
           "the first pairs are not known before all are found"},
          {options.traversal->named(), "a traversal by name",
           "it needs the binary tree of the whole model"}};
}

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
                             "count the pairs without listing them; not with -o FILE.csv")
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
  add_renamed_outputs(
      parser, options.outputs,
      {AnswerFile::csv, AnswerFile::npz, AnswerFile::json, AnswerFile::lines, AnswerFile::page},
      group);
  add_shard(parser, options, kQuestionGroup);
  add_length(
      parser, "--clearance", options.clearance,
      "only decide whether they are within D, as soms within does; not with options of pairs")
      ->old_name("--within")
      ->group(group);
  add_verify(parser, options);
}

/// \errors ErrorKind::usage for a condition that is not part of the question.
void check_condition(const std::string& condition, bool within) {
  if (within && condition == "overlap") {
    throw Error(ErrorKind::usage, "--fail-if overlap has no effect with --clearance",
                "give --fail-if within, or leave --clearance out");
  }
  if (!within && condition == "within") {
    throw Error(ErrorKind::usage, "--fail-if within has no effect without --clearance",
                "also give --clearance D");
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
      throw Error(ErrorKind::usage, fmt::format("{} has no effect with --clearance", idle),
                  "leave one of them out");
    }
  }
  WithinVerbOptions within;
  static_cast<PairOptions&>(within) = options;
  within.verb = "overlap";
  within.clearance = options.clearance;
  within.fail_if_within = !options.fail_if.empty();
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
    const bool within = parser.count("--clearance") > 0;
    check_condition(options->fail_if, within);
    if (within) {
      return run_within_of(parser, *options, console);
    }
    options->traversal->check(parser);
    if (!options->list_pairs && options->query.mode != OverlapMode::all && !console.shared().json &&
        options->outputs.npz.empty() && options->outputs.json.empty() &&
        options->outputs.lines.empty()) {
      throw Error(ErrorKind::usage,
                  "--no-pairs has no effect: --any and --first list no pairs without --json",
                  "leave it out, or also give --json or -o FILE.npz");
    }
    if (!options->list_pairs && !options->outputs.csv.empty()) {
      throw Error(ErrorKind::usage,
                  fmt::format("-o {} has a row for each pair, and --no-pairs leaves them out",
                              options->outputs.csv),
                  "leave one of them out");
    }
    return run_overlap(*options, console);
  };
}

int run_overlap(const OverlapVerbOptions& options, Console& console) {
  return run_pairs(options,
                   {.verb = "overlap",
                    .terms = terms_of(options),
                    .fail_if_found = !options.fail_if.empty(),
                    .keep_trees = options.traversal->named(),
                    .is_free = options.query.mode == OverlapMode::any,
                    .refused_of_tiles = refused_of_tiles(options)},
                   console,
                   [&](const PoseRows& rows) { return OverlapQuestion(rows, options, console); });
}

}  // namespace soms::command
