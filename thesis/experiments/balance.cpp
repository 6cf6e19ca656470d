// Is a tree by SOMS more balanced? Balanced levels and depths of leaves, by rule and model.
#include "thesis/experiments/experiments.h"
#include "thesis/pictures/count_charts.h"
#include "thesis/run/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace soms::reproduce {

namespace {

constexpr std::array<std::string_view, 14> kBalanceColumns{
    "model",          "origin",         "triangles", "rule",           "midpoint",
    "axis_from",      "empty_side",     "level",     "possible_level", "balanced_level",
    "min_leaf_depth", "max_leaf_depth", "leaves",    "largest_leaf"};

constexpr std::array kThesisEmptySides{EmptySide::stop, EmptySide::next_axis};

struct BalanceTask {
  const Model* model = nullptr;
  int level = 0;
};

std::uint64_t balanced(std::span<const Counted> counts, const BalanceTask& task, Rule rule,
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

Score score_against(Rule rule, EmptySide policy, std::span<const BalanceTask> tasks,
                    std::span<const Counted> counts) {
  Score score;
  for (const BalanceTask& task : tasks) {
    const std::uint64_t soms = balanced(counts, task, Rule::soms, policy);
    const std::uint64_t other = balanced(counts, task, rule, policy);
    ++(soms > other ? score.higher : soms == other ? score.equal : score.lower);
    score.text +=
        fmt::format("{}{} {} to {}", score.text.empty() ? "" : ", ", task.model->name, soms, other);
  }
  return score;
}

std::string score_words(const Score& score) {
  return fmt::format("higher on {}, equal on {}, lower on {}", score.higher, score.equal,
                     score.lower);
}

std::string against_object_rules(std::span<const BalanceTask> tasks,
                                 std::span<const Counted> counts) {
  const Score median = score_against(Rule::object_median, EmptySide::stop, tasks, counts);
  const Score mean = score_against(Rule::object_mean, EmptySide::stop, tasks, counts);
  return fmt::format(
      "Object median halves the number of triangles at every node, so no rule balances better: the "
      "balanced level of SOMS is {} of {} models ({}). Against object mean it is {} ({}).",
      score_words(median), tasks.size(), median.text, score_words(mean), mean.text);
}

std::string leaf_depths(std::span<const BalanceTask> tasks, std::span<const Counted> counts) {
  int even = 0;
  int even_soms = 0;
  const auto spread = [&](const BalanceTask& task, Rule rule) {
    const TreeStatistics& s =
        find_count(counts, *task.model, thesis_options(rule, task.level))->counts;
    return s.max_leaf_depth - s.min_leaf_depth;
  };
  for (const BalanceTask& task : tasks) {
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
  std::vector<BalanceTask> tasks;
  for (const Model& model : context.models.objects) {
    tasks.push_back({&model, kObjectLevel});
  }
  for (const Model& model : context.models.scenes) {
    tasks.push_back({&model, kSceneLevel});
  }
  Steps steps(context.limits, tasks.size());
  std::vector<Counted> counts;
  for (const BalanceTask& task : tasks) {
    for (const Contender& contender : with_each(all_builds(task.level), kThesisEmptySides)) {
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
          kBalanceColumns, counts)},
      .figures = {{.id = "balance",
                   .caption = fmt::format("Balanced level: higher is more balanced.{}{}",
                                          kComparedOptions, note),
                   .svg = bars_of("Balanced level", "level", with_usual_options(counts),
                                  balanced_level)}},
      .remarks = {against_object_rules(tasks, counts), leaf_depths(tasks, counts),
                  "In today's terms SOMS is midpoint splitting of the bounds of the centroids, the "
                  "\"middle\" of PBRT, with an unusual centroid: it divides wherever two midpoints "
                  "differ, and it counts neither triangles nor costs."}};
}

}  // namespace soms::reproduce
