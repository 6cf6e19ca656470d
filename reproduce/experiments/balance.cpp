// Is a tree by SOMS more balanced? Balanced levels and depths of leaves, by rule and model.
#include "soms/tree/option_names.h"

#include "reproduce/count_charts.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 14> kColumns{
    "model",          "origin",         "triangles", "rule",           "midpoint",
    "axis_from",      "empty_side",     "level",     "possible_level", "balanced_level",
    "min_leaf_depth", "max_leaf_depth", "leaves",    "largest_leaf"};

constexpr std::array kPolicies{EmptySide::stop, EmptySide::next_axis};

struct Task {
  const Model* model = nullptr;
  int level = 0;
};

std::uint64_t balanced(std::span<const Counted> counts, const Task& task, Rule rule,
                       EmptySide policy) {
  BuildOptions options = thesis_options(rule, task.level);
  options.empty_side = rule == Rule::object_median ? EmptySide::stop : policy;
  return find_count(counts, *task.model, options)->counts.balanced_level;
}

/// On how many models SOMS has the higher, the same, the lower balanced level than another rule.
struct Score {
  int higher = 0;
  int equal = 0;
  int lower = 0;
  std::string text = {};
};

Score score_against(Rule rule, EmptySide policy, std::span<const Task> tasks,
                    std::span<const Counted> counts) {
  Score score;
  for (const Task& task : tasks) {
    const std::uint64_t soms = balanced(counts, task, Rule::soms, policy);
    const std::uint64_t other = balanced(counts, task, rule, policy);
    ++(soms > other ? score.higher : soms == other ? score.equal : score.lower);
    score.text +=
        fmt::format("{}{} {} to {}", score.text.empty() ? "" : ", ", task.model->name, soms, other);
  }
  return score;
}

std::string words(const Score& score) {
  return fmt::format("higher on {}, equal on {}, lower on {}", score.higher, score.equal,
                     score.lower);
}

Finding against_spatial_median(std::span<const Task> tasks, std::span<const Counted> counts,
                               const std::string& note) {
  Finding finding{.claim = "SOMS makes a more balanced tree than spatial median",
                  .source = "abstract; figure 4.2 by its caption"};
  int higher = 0;
  int all = 0;
  const auto stand_ins = std::count_if(tasks.begin(), tasks.end(),
                                       [](const Task& task) { return task.model->stand_in; });
  finding.measured =
      fmt::format("Balanced level, SOMS to spatial median, on {} models, {} of them stand-ins.",
                  tasks.size(), stand_ins);
  for (const EmptySide policy : kPolicies) {
    const Score score = score_against(Rule::spatial_median, policy, tasks, counts);
    finding.measured += fmt::format(" Empty side {}: {}.", name(policy), score.text);
    finding.reason += fmt::format(
        "{}With empty side {} the balanced level of SOMS is {} of {} "
        "models.",
        finding.reason.empty() ? "" : " ", name(policy), words(score), tasks.size());
    higher += score.higher;
    all += score.higher + score.equal + score.lower;
  }
  finding.measured += note;
  if (higher > 0 && higher < all) {
    finding.reason += " It is a matter of the model, not of the rule alone.";
  }
  finding.verdict = higher == all ? Verdict::holds
                    : higher > 0  ? Verdict::holds_under
                                  : Verdict::does_not_hold;
  return finding;
}

std::string against_object_rules(std::span<const Task> tasks, std::span<const Counted> counts) {
  const Score median = score_against(Rule::object_median, EmptySide::stop, tasks, counts);
  const Score mean = score_against(Rule::object_mean, EmptySide::stop, tasks, counts);
  return fmt::format(
      "Object median halves the number of triangles at every node, so no rule balances better: the "
      "balanced level of SOMS is {} of {} models ({}). Against object mean it is {} ({}).",
      words(median), tasks.size(), median.text, words(mean), mean.text);
}

std::string leaf_depths(std::span<const Task> tasks, std::span<const Counted> counts) {
  int even = 0;
  int even_soms = 0;
  const auto spread = [&](const Task& task, Rule rule) {
    const TreeStatistics& s =
        find_count(counts, *task.model, thesis_options(rule, task.level))->counts;
    return s.max_leaf_depth - s.min_leaf_depth;
  };
  for (const Task& task : tasks) {
    even += spread(task, Rule::object_median) <= 1 ? 1 : 0;
    even_soms += spread(task, Rule::soms) <= 1 ? 1 : 0;
  }
  return fmt::format(
      "Depths of leaves differ by at most one on {} of {} models by object median, on "
      "{} by SOMS.",
      even, tasks.size(), even_soms);
}

}  // namespace

Result balance(const Context& context) {
  std::vector<Task> tasks;
  for (const Model& model : context.models.objects) {
    tasks.push_back({&model, kObjectLevel});
  }
  for (const Model& model : context.models.scenes) {
    tasks.push_back({&model, kSceneLevel});
  }
  Steps steps(context.parallel, tasks.size());
  std::vector<Counted> counts;
  for (const Task& task : tasks) {
    for (const Contender& contender : with_each(all_builds(task.level), kPolicies)) {
      counts.push_back(count(*task.model, contender, steps.quiet()));
    }
    steps.done_one();
  }
  const std::string note =
      note_on_stand_ins(context.models.objects) + note_on_stand_ins(context.models.scenes);
  return {
      .tables = {count_table(
          "balance",
          "Balanced level (the greatest of which every node exists and holds a "
          "triangle) and depths of leaves; possible_level is the greatest that so "
          "many triangles allow." +
              note,
          kColumns, counts)},
      .figures = {{.id = "balance",
                   .caption = fmt::format("Balanced level: higher is more balanced.{}{}",
                                          kComparedOptions, note),
                   .svg = bars_of("Balanced level", "level", with_usual_options(counts),
                                  balanced_level)}},
      .findings = {against_spatial_median(tasks, counts, note)},
      .remarks = {against_object_rules(tasks, counts), leaf_depths(tasks, counts),
                  "In today's terms SOMS is midpoint splitting of the bounds of the centroids, the "
                  "\"middle\" of PBRT, with an unusual centroid: it divides wherever two midpoints "
                  "differ, and it counts neither triangles nor costs."}};
}

}  // namespace soms::reproduce
