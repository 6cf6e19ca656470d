#include "apps/soms/clash/clash.h"

#include "soms/base/error.h"
#include "soms/clash/part_keys.h"

#include "apps/cli/console.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"
#include "apps/output/output.h"
#include "apps/rows/json_list.h"
#include "apps/soms/clash/clash_baseline.h"
#include "apps/soms/clash/clash_looked_at.h"
#include "apps/soms/clash/clash_output.h"
#include "apps/soms/clash/clash_rows.h"
#include "apps/soms/clash/clash_run.h"
#include "apps/soms/clash/clash_text.h"
#include "apps/soms/pairs/pair_options.h"
#include "apps/soms/solid/solid_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <span>
#include <sstream>
#include <utility>

namespace soms::command {

namespace {

ClashOptions library_options(const ClashVerbOptions& options, const ClashModels& models) {
  ClashOptions wanted{.within = options.within};
  if (!options.sets.between.empty()) {
    wanted.wanted = [&](std::uint32_t a, std::uint32_t b) {
      return bodies_are_compared(options.sets, models, a, b);
    };
  }
  return wanted;
}

/// Crossing, inside or the same, and nobody knows how deep, as a part is not convex.
bool has_unknown_depth(const Clash& clash) {
  return shares_interior(clash.relation) && !clash.penetration;
}

/// At most so deep; what touches is not deep at all, and nothing else is 0 deep. Depths are rounded
/// up, so that parts that are just as deep as the tolerance would be kept without some room.
bool is_within_tolerance(const Clash& clash, double tolerance) {
  constexpr double kRoom = 1e-9;
  return clash.kind == ClashKind::touching || (tolerance > 0 && clash.penetration &&
                                               clash.penetration->depth <= tolerance * (1 + kRoom));
}

/// Leaves out what options name, and says how much that was.
void remove_ignored(const ClashVerbOptions& options, const IgnoredPairs& pairs,
                    ClashReport& report) {
  const auto remove = [&](const std::string& what, const auto& ignored) {
    const std::size_t count = std::erase_if(report.rows, ignored);
    report.removed.emplace_back(what, count);
  };
  if (options.tolerance) {
    remove("tolerance",
           [&](const ClashRow& row) { return is_within_tolerance(row.clash, *options.tolerance); });
    const auto unknown =
        std::count_if(report.rows.begin(), report.rows.end(),
                      [](const ClashRow& row) { return has_unknown_depth(row.clash); });
    report.removed_by_tolerance = true;
    report.unknown_depth = static_cast<std::uint64_t>(unknown);
  }
  for (const std::string& kind : options.ignored_kinds) {
    remove(kind, [&](const ClashRow& row) { return name(row.clash.kind) == kind; });
  }
  if (options.ignore_siblings) {
    remove("ignore-siblings",
           [&](const ClashRow& row) { return are_siblings(report.models, row.clash); });
  }
  if (!options.ignored_pairs.empty()) {
    remove("ignore-pairs",
           [&](const ClashRow& row) { return pairs.match(report.models, row.clash); });
  }
}

/// The filters of `remove_ignored` that rows may be removed by, by the same names.
std::vector<std::string> filters_of(const ClashVerbOptions& options) {
  std::vector<std::string> filters = options.ignored_kinds;
  if (options.tolerance) {
    filters.emplace_back("tolerance");
  }
  if (options.ignore_siblings) {
    filters.emplace_back("ignore-siblings");
  }
  if (!options.ignored_pairs.empty()) {
    filters.emplace_back("ignore-pairs");
  }
  return filters;
}

/// Leaves out clashes of other statuses than those that are to be listed.
void keep_statuses(const std::vector<std::string>& statuses, ClashReport& report) {
  if (statuses.empty()) {
    return;
  }
  const auto is_listed = [&](std::string_view status) {
    return std::find(statuses.begin(), statuses.end(), status) != statuses.end();
  };
  std::uint64_t removed = std::erase_if(
      report.rows, [&](const ClashRow& row) { return !is_listed(status_name(row.status)); });
  if (!is_listed(kResolved)) {
    removed += report.resolved.size();
    report.resolved.clear();
  }
  report.removed.emplace_back("status", removed);
}

/// The list of what was decided.
ClashReport report_of(const ClashModels& models, const ClashRun& run,
                      const ClashVerbOptions& options, const IgnoredPairs& ignored,
                      const std::optional<ClashBaseline>& baseline, const Console& console) {
  ClashReport report{.models = models,
                     .compared = run.compared,
                     .left = run.left,
                     .interrupted = run.interrupted,
                     .timed_out = run.left != 0 && console.out_of_time(),
                     .cost = run.cost,
                     .resumed = run.resumed,
                     .grouped = options.grouping.by != ClashGroup::none};
  std::set<std::uint64_t> found;
  const ClashGroups group_of(options.grouping, models);
  for (const Clash& clash : run.clashes) {
    if (!is_looked_for(options.sets, models, clash)) {
      continue;
    }
    const std::uint64_t key = clash_key(models.a.keys[clash.a], models.second().keys[clash.b]);
    report.rows.push_back({.clash = clash, .key = key, .group = group_of(clash)});
    found.insert(key);
  }
  remove_ignored(options, ignored, report);
  sort_rows(models, report.rows);
  if (baseline) {
    baseline->compare(found, LookedAt(models, options.sets, options.within), report);
  }
  keep_statuses(options.statuses, report);
  for (const ClashRow& row : report.rows) {
    ++report.by_kind[static_cast<std::size_t>(row.clash.kind)];
  }
  return report;
}

/// Reports where the run began and ended, if not at the first and the last pair.
void tell_progress(const ClashReport& report, const ClashRun& run, const Console& console) {
  if (run.resumed != 0) {
    console.note(fmt::format("the journal had {} of {} of parts", with_commas(run.resumed),
                             counted(run.candidates.size(), "pair")));
  }
  if (report.timed_out) {
    console.note(fmt::format("out of time after {} of {} of parts", with_commas(report.compared),
                             counted(run.candidates.size(), "pair")));
  }
}

bool fails(const ClashVerbOptions& options, const ClashReport& report) {
  return std::any_of(report.rows.begin(), report.rows.end(), [&](const ClashRow& row) {
    switch (options.fail_if) {
      case ClashFailure::listed:
        return true;
      case ClashFailure::hard:
        return shares_interior(row.clash.relation);
      case ClashFailure::fresh:
        return row.status == ClashStatus::fresh;
      case ClashFailure::never:
        break;
    }
    return false;
  });
}

int status_of(const ClashVerbOptions& options, const ClashReport& report, std::uint64_t wrong) {
  if (wrong != 0) {
    return kDifference;
  }
  if (report.interrupted) {
    return kInterrupted;
  }
  if (fails(options, report)) {
    return kConditionHolds;
  }
  // "Not found" is no proof that there is nothing when time ran out.
  return options.fail_if != ClashFailure::never && !report.complete() ? kOutOfTime : 0;
}

void check_options(const ClashVerbOptions& options) {
  NamedFiles taken{{"--ignore-pairs", options.ignored_pairs},
                   {"--baseline", options.baseline},
                   {"--journal", options.journal}};
  for (const std::string& file : options.models.files) {
    taken.emplace_back("FILE", file);
  }
  for (const std::string& file : options.models.against) {
    taken.emplace_back("--against", file);
  }
  NamedFiles outputs;
  for (const std::string& file : options.outputs) {
    outputs.emplace_back("-o", file);
  }
  check_outputs(std::move(taken), outputs);
  const ModelOptions& second = options.models.model_against;
  if (options.models.against.empty() && (second.scale_is_given || second.up != UpAxis::unknown ||
                                         !second.crs.empty() || second.lod || second.surfaces)) {
    throw Error(
        ErrorKind::usage,
        "--scale-b, --up-b, --crs-b, --lod-b and --surfaces-b have no effect without --against",
        "leave them out, or also give --against FILE");
  }
  check_clash_file_options(options.files, options.outputs);
  if (!options.statuses.empty() && options.baseline.empty()) {
    throw Error(ErrorKind::usage, "--status has no effect without --baseline",
                "also give --baseline FILE");
  }
  if (options.fail_if == ClashFailure::fresh && options.baseline.empty()) {
    throw Error(ErrorKind::usage, "--fail-if new has no effect without --baseline",
                "also give --baseline FILE");
  }
}

void add_clash_questions(Parser& parser, ClashVerbOptions& options) {
  parser
      .add_option_function(
          "--clearance",
          [&options](const std::string& text) {
            options.within = parse_number("--clearance", text);
            check(ClashOptions{.within = options.within});
          },
          "also list parts that share nothing and are at most D apart, as near")
      ->old_name("--within")
      ->option_text("D")
      ->group(kQuestionGroup);
  std::vector<std::string> kinds;
  for (std::size_t k = 0; k < kClashKinds; ++k) {
    kinds.emplace_back(name(static_cast<ClashKind>(k)));
  }
  parser
      .add_each_time(
          "--ignore-class",
          [&options, kinds](const std::string& name) {
            if (std::find(kinds.begin(), kinds.end(), name) == kinds.end()) {
              throw unknown_choice("--ignore-class", name, kinds);
            }
            options.ignored_kinds.push_back(name);
          },
          "leave out clashes of a class (repeatable): " + word_list(kinds))
      ->old_name("--ignore",
                 [kinds](const std::string& value) {
                   return std::find(kinds.begin(), kinds.end(), value) != kinds.end();
                 })
      ->option_text(kChoiceText)
      ->choices(kinds)
      ->group(kQuestionGroup);
  parser
      .add_option("--ignore-pairs", options.ignored_pairs,
                  "leave out pairs of parts that fit a line \"PATTERN,PATTERN\" of this file")
      ->option_text("FILE")
      ->group(kQuestionGroup);
  parser
      .add_flag("--ignore-siblings", options.ignore_siblings,
                "leave out pairs of parts of one object, as the parts of a building are")
      ->group(kQuestionGroup);
  parser
      .add_option_function(
          "--tolerance",
          [&options](const std::string& text) {
            options.tolerance = parse_number("--tolerance", text);
            if (!(std::isfinite(*options.tolerance) && *options.tolerance >= 0)) {
              throw Error(ErrorKind::usage, "--tolerance " + text + " is not a depth",
                          "give a finite number of at least 0");
            }
          },
          "leave out what touches, and convex parts that are at most D deep in each other")
      ->option_text("D")
      ->group(kQuestionGroup);
  parser
      .add_option("--baseline", options.baseline,
                  "an older list, as JSON: which clashes are new, active or resolved")
      ->option_text("FILE")
      ->group(kQuestionGroup);
  parser
      .add_each_time(
          "--status",
          [&options](const std::string& name) {
            if (name != "new" && name != "active" && name != kResolved) {
              throw unknown_choice("--status", name, {"new", "active", std::string(kResolved)});
            }
            options.statuses.push_back(name);
          },
          "list only clashes that are new, active or resolved (repeatable)")
      ->option_text(kChoiceText)
      ->choices({"new", "active", std::string(kResolved)})
      ->group(kQuestionGroup);
  add_choice<ClashFailure>(
      parser, "--fail-if", options.fail_if,
      {{"clash", ClashFailure::listed}, {"hard", ClashFailure::hard}, {"new", ClashFailure::fresh}},
      "exit with 1 if a clash is listed, one shares interior, or one is new")
      ->group(kQuestionGroup);
  parser
      .add_option("--journal", options.journal,
                  "keep what is decided in a file, and go on from it when run again")
      ->option_text("FILE")
      ->group(kQuestionGroup);
  parser
      .add_flag("--verify", options.verify,
                "compare every pair of parts with brute force; exit with status 6 if they differ")
      ->group(kQuestionGroup);
}

void add_clash_sets(Parser& parser, ClashVerbOptions& options) {
  parser
      .add_each_time(
          "--set",
          [&options](const std::string& word) {
            options.sets.patterns.push_back(set_pattern(word));
          },
          "parts whose name, id, type or file fits a pattern are a set (repeatable); others by "
          "file")
      ->option_text("NAME=PATTERN")
      ->group(kQuestionGroup);
  parser
      .add_each_time(
          "--between",
          [&options](const std::string& word) { options.sets.between.push_back(set_pair(word)); },
          "compare only parts of these two sets (repeatable)")
      ->option_text("SET,SET")
      ->group(kQuestionGroup);
  parser
      .add_option_function(
          "--group-by",
          [&options](const std::string& word) { options.grouping = clash_grouping(word); },
          "count clashes by a, b, parent, type, set or cell=SIZE")
      ->option_text("WHAT")
      ->group(kQuestionGroup);
}

}  // namespace

Action add_clash(Parser& parser, Shared&) {
  const auto options = std::make_shared<ClashVerbOptions>();
  parser
      .add_option("FILE", options->models.files,
                  "models whose parts are compared; a folder stands for the models in it, without "
                  "subfolders")
      ->required();
  parser
      .add_option("--against", options->models.against,
                  "models of a second set: parts of the first are compared with those of the "
                  "second alone")
      ->option_text("FILE...")
      ->group(kQuestionGroup);
  add_clash_questions(parser, *options);
  add_clash_sets(parser, *options);
  add_repeatable(parser, "-o,--output", options->outputs,
                 "write the list: .csv, .json, .jsonl, .html, .bcfzip or .bcf; may be repeated",
                 "FILE");
  add_clash_file_options(parser, options->files);
  add_model_options(parser, options->models.model, "--scale", "--up", "the models");
  add_model_options(parser, options->models.model_against, "--scale-b", "--up-b",
                    "the models of --against");
  add_city_options(parser, options->models.model, "", "the models");
  add_city_options(parser, options->models.model_against, "-b", "the models of --against");
  add_strict(parser, options->models.model.strict);
  add_part_filter(parser, options->models.model.parts, "the models");
  parser.footer(
      "Exact: crossing, inside, same or touching, as soms solid says of each pair of parts. If a\n"
      "part is open, the pair is undecided where the answer depends on what the part encloses." +
      example_of_pair("clash knot.ply --against ball.off --clearance 0.1 -o clashes.csv"));
  return [options, &parser](Console& console) {
    options->files.command = stated_command(parser);
    options->models.model_against.strict = options->models.model.strict;
    options->models.model_against.parts = options->models.model.parts;
    options->models.expected_gap = options->within.value_or(0);
    return run_clash(*options, console);
  };
}

int run_clash(const ClashVerbOptions& options, Console& console) {
  check_options(options);
  const IgnoredPairs ignored =
      options.ignored_pairs.empty() ? IgnoredPairs() : IgnoredPairs(options.ignored_pairs);
  std::optional<ClashBaseline> baseline;
  if (!options.baseline.empty()) {
    baseline.emplace(options.baseline, filters_of(options));
  }
  std::vector<std::pair<std::string, std::unique_ptr<OutputFile>>> files;
  for (const std::string& file : options.outputs) {
    files.emplace_back(file, std::make_unique<OutputFile>(file));
  }
  if (!files.empty()) {
    console.go_on_without_reader();
  }
  ClashModels models = read_clash_models(options.models, console);
  give_sets(options.sets, models);
  const ClashOptions wanted = library_options(options, models);
  const ClashRun run = decide_clashes(models, wanted, options.journal, console);
  const ClashReport report = report_of(models, run, options, ignored, baseline, console);
  tell_progress(report, run, console);
  const bool verify = options.verify && !report.interrupted && report.complete();
  if (options.verify && !verify) {
    console.note("not verified, as not all pairs of parts were decided");
  }
  const std::uint64_t wrong = verify ? count_wrong_clashes(models, run, wanted, console) : 0;
  if (console.shared().json) {
    std::ostringstream text;
    JsonListWriter list(text, {});
    write_clashes_as_json(report, verify && wrong == 0, list);
    console.print(text.str());
  } else {
    print_clashes_as_text(report, console);
    if (verify) {
      console.print(fmt::format("verified by brute force: {} of {} equal\n",
                                with_commas(models.pairs() - wrong),
                                counted(models.pairs(), "pair")));
    }
  }
  console.flush();
  for (const auto& [name, file] : files) {
    write_clash_file(name, report, verify && wrong == 0, options.files, console, file->stream());
    file->commit();
  }
  return status_of(options, report, wrong);
}

}  // namespace soms::command
