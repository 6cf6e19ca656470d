#include "thesis/trees/build_times.h"

#include "soms/tree/build.h"

#include "thesis/trips/statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <utility>

namespace soms::reproduce {

namespace {

/// Models of more triangles are larger than the thesis' and are built less often.
constexpr std::size_t kLarge = 10'000;

/// Builds before those that count.
int warm_up(int repetitions) {
  return std::min(10, repetitions);
}

/// What a build is compared with: spatial median at its level, or at the greatest level timed.
const TimedBuild* base_of(const TimedBuild& one, std::span<const TimedBuild> builds) {
  int level = one.counted.contender.options.level;
  if (level == 0) {
    for (const TimedBuild& other : builds) {
      const bool same = other.counted.model == one.counted.model;
      level = std::max(level, same ? other.counted.contender.options.level : 0);
    }
  }
  return find_build(builds, *one.counted.model, Rule::spatial_median, level);
}

/// Microseconds for a node, from milliseconds for the tree.
Cell per_node(const TimedBuild& one, double milliseconds) {
  if (one.counted.counts.nodes == 0) {
    return {};
  }
  return 1000 * milliseconds / static_cast<double>(one.counted.counts.nodes);
}

Cell above(const TimedBuild& one, const TimedBuild* base) {
  if (base == nullptr) {
    return {};
  }
  return 100 * (one.timing.median / base->timing.median - 1);
}

}  // namespace

int repetitions(const Context& context, int whole, const Model& model) {
  const int usual = context.repetitions(whole);
  const std::size_t triangles = model.mesh->triangles.size();
  if (triangles <= kLarge) {
    return usual;
  }
  const auto fewer = static_cast<std::size_t>(usual) * kLarge / triangles;
  return std::min(usual, std::max(5, static_cast<int>(fewer)));
}

std::string words_on_repetitions(const Context& context, int whole, RepetitionsOf whose,
                                 std::span<const Model> models) {
  const int usual = context.repetitions(whole);
  const bool fewer = std::any_of(models.begin(), models.end(), [](const Model& model) {
    return model.mesh->triangles.size() > kLarge;
  });
  const auto number = [](int count) { return words(static_cast<std::uint64_t>(count)); };
  return fmt::format(
      " Each tree is built {} times{}, {}{}.", number(usual),
      usual == whole ? "" : fmt::format(" ({} in a whole run)", number(whole)),
      whose == RepetitionsOf::thesis ? "the number of the thesis' caption"
                                     : "a number of ours, for the thesis' caption names none",
      fewer ? fmt::format("; of a model of more than {} triangles fewer times, see column builds",
                          words(kLarge))
            : "");
}

std::size_t rounds(int repetitions) {
  return static_cast<std::size_t>(repetitions) + static_cast<std::size_t>(warm_up(repetitions));
}

std::vector<TimedBuild> time_builds(const Model& model, std::span<const Contender> contenders,
                                    int repetitions, Steps& steps) {
  const Limits quiet = steps.quiet();
  std::vector<TimedBuild> builds;
  // Each build keeps its last tree, so that all free one tree a run, as a program would that
  // replaces its tree.
  std::vector<Tree> trees(contenders.size());
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    builds.push_back({count(model, contenders[i], quiet), {}});
    works.emplace_back([&tree = trees[i], &mesh = *model.mesh, &options = contenders[i].options] {
      tree = build(mesh, options);
    });
  }
  works.emplace_back([&steps] { steps.done_one(); });
  const std::vector<Timing> timings = time_in_turn(repetitions, quiet, works, warm_up(repetitions));
  for (std::size_t i = 0; i < builds.size(); ++i) {
    builds[i].timing = timings[i];
  }
  return builds;
}

Table time_table(std::string id, std::string caption, std::span<const TimedBuild> builds) {
  Table table{std::move(id), std::move(caption), columns_of(kBuildColumns), {}};
  table.columns.push_back({"builds"});
  for (const char* const name :
       {"median", "lower_quartile", "upper_quartile", "mean", "min", "deviation", "low", "high"}) {
    table.columns.push_back({name, "ms", ColumnKind::timed});
  }
  table.columns.push_back({"mean_per_node", "us", ColumnKind::timed});
  table.columns.push_back({"median_per_node", "us", ColumnKind::timed});
  table.columns.push_back({"above_spatial_median", "%", ColumnKind::timed});
  const std::vector<Column> last = columns_of(kBuildOptionColumns);
  table.columns.insert(table.columns.end(), last.begin(), last.end());
  for (const TimedBuild& one : builds) {
    const Timing& t = one.timing;
    std::vector<Cell> row = cells_of(one.counted, kBuildColumns);
    row.emplace_back(std::int64_t{t.repetitions});
    for (const double ms :
         {t.median, t.lower_quartile, t.upper_quartile, t.mean, t.min, t.deviation}) {
      row.emplace_back(ms);
    }
    const Interval interval = estimate(t.rounds, t.processes).interval;
    row.emplace_back(interval.low);
    row.emplace_back(interval.high);
    row.push_back(per_node(one, t.mean));
    row.push_back(per_node(one, t.median));
    row.push_back(above(one, base_of(one, builds)));
    const std::vector<Cell> options = cells_of(one.counted, kBuildOptionColumns);
    row.insert(row.end(), options.begin(), options.end());
    table.rows.push_back(std::move(row));
  }
  return table;
}

const TimedBuild* find_build(std::span<const TimedBuild> builds, const Model& model, Rule rule,
                             int level) {
  const auto found = std::find_if(builds.begin(), builds.end(), [&](const TimedBuild& one) {
    const Contender& contender = one.counted.contender;
    return one.counted.model == &model && contender.of_thesis && contender.options.rule == rule &&
           contender.options.level == level;
  });
  return found == builds.end() ? nullptr : &*found;
}

}  // namespace soms::reproduce
