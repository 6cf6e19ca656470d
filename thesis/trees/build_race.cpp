#include "thesis/trees/build_race.h"

#include "soms/tree/build.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"

#include "thesis/run/counts.h"
#include "thesis/trees/open_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace soms::reproduce {

namespace {

/// Triangles built between two readings of the clock, and most builds: a reading costs some tenths
/// of a microsecond, which would draw the ratio of short times toward one.
constexpr std::size_t kBetweenReadings = 4000;
constexpr std::size_t kMostBuilds = 4;

/// Rounds before the clock counts, of all processes together.
constexpr int kUncountedBuilds = 5;

constexpr std::array kRacedRules{Rule::spatial_median, Rule::soms};

/// A build that can be run again and again.
struct RacedBuilder {
  BuildOptions options = {};
  std::optional<NeutralBuilder> neutral = {};  ///< none for the library's builder
  Tree tree = {};

  void run(const Mesh& mesh) { tree = neutral ? neutral->build(mesh) : build(mesh, options); }
};

RacedBuilder runner_of(Builder builder, const BuildOptions& options) {
  RacedBuilder runner{.options = options};
  if (builder != Builder::library) {
    runner.neutral.emplace(
        builder == Builder::in_place ? NeutralWay::in_place : NeutralWay::thesis_like, options);
  }
  return runner;
}

std::vector<RacedBuilder> runners_of(const RaceTask& task) {
  std::vector<RacedBuilder> runners;
  for (const Builder builder : kBuilders) {
    for (const Rule rule : kRacedRules) {
      BuildOptions options = thesis_options(rule, task.level);
      options.empty_side = task.empty_side;
      runners.push_back(runner_of(builder, options));
    }
  }
  return runners;
}

Timing per_build(const Timing& timing, std::size_t builds) {
  std::vector<double> rounds = timing.rounds;
  for (double& round : rounds) {
    round /= static_cast<double>(builds);
  }
  return summarize(std::move(rounds), timing.processes);
}

Estimate gain_of(const Race& race, double factor) {
  const Estimate ratio = paired_ratio(race.soms.timing.rounds, race.spatial_median.timing.rounds,
                                      race.soms.timing.processes);
  const auto percent = [&](double value) { return 100 * (1 - factor * value); };
  return {percent(ratio.value),
          {percent(ratio.interval.high), percent(ratio.interval.low)},
          ratio.rounds,
          ratio.processes};
}

void add(std::vector<Cell>& row, const Estimate& estimate) {
  row.emplace_back(estimate.value);
  row.emplace_back(estimate.interval.low);
  row.emplace_back(estimate.interval.high);
}

std::vector<Cell> row_of(const Race& race, Rule rule) {
  const bool soms = rule == Rule::soms;
  const RaceHalf& racer = soms ? race.soms : race.spatial_median;
  const auto count = [](std::uint64_t value) { return Cell{static_cast<std::int64_t>(value)}; };
  std::vector<Cell> row{race.model->name,
                        std::string(name_of(race.builder)),
                        std::string(entry(rule).name),
                        std::string(name(race.empty_side)),
                        std::int64_t{race.level},
                        count(racer.counts.nodes),
                        count(racer.work.compared)};
  for (const std::uint64_t grown : {racer.work.outer, racer.work.inner, racer.work.merged}) {
    row.push_back(race.builder == Builder::library ? Cell{} : count(grown));
  }
  row.emplace_back(std::int64_t{racer.timing.repetitions});
  row.emplace_back(std::int64_t{racer.timing.processes});
  add(row, estimate(racer.timing.rounds, racer.timing.processes));
  if (soms) {
    add(row, gain(race));
    add(row, gain_per_node(race));
  } else {
    row.resize(row.size() + 6);
  }
  return row;
}

}  // namespace

std::string_view name_of(Builder builder) {
  constexpr std::array<std::string_view, kBuilders.size()> kNames{"library", "thesis_like",
                                                                  "in_place"};
  return kNames[static_cast<std::size_t>(builder)];
}

std::string_view title_of(Builder builder) {
  constexpr std::array<std::string_view, kBuilders.size()> kTitles{
      "library's builder", "neutral builder, thesis-like", "neutral builder, in place"};
  return kTitles[static_cast<std::size_t>(builder)];
}

std::string_view reading_of(Builder builder) {
  return builder == Builder::library ? "library's builder, gives spatial median one pass more"
                                     : title_of(builder);
}

std::string_view fallback_words(EmptySide empty_side) {
  constexpr std::array<std::string_view, kFallbacks.size()> kWords{
      "a node stays whole where a side is empty", "other axes where a side is empty",
      "object median where a side is empty",
      "a node without triangles where a side is empty (table 5.5)"};
  return kWords[static_cast<std::size_t>(empty_side)];
}

bool has_empty_sides(const Model& model, int level, const Limits& limits) {
  return std::any_of(kRacedRules.begin(), kRacedRules.end(), [&](Rule rule) {
    return counts_of(*model.mesh, rule, level, {}, limits).undividable > 0;
  });
}

std::size_t race_steps(const RaceProcess& process, int rounds) {
  return static_cast<std::size_t>(rounds_of_each(process, rounds) +
                                  rounds_of_each(process, kUncountedBuilds));
}

std::vector<Race> race(RaceProcess& process, const RaceTask& task, int rounds, Steps& steps) {
  const Mesh& mesh = *task.model->mesh;
  const std::size_t builds = std::clamp<std::size_t>(
      kBetweenReadings / std::max<std::size_t>(1, mesh.triangles.size()), 1, kMostBuilds);
  std::vector<RacedBuilder> runners = runners_of(task);
  std::vector<std::function<void()>> works;
  works.reserve(runners.size() + 1);
  for (RacedBuilder& runner : runners) {
    works.emplace_back([&runner, &mesh, builds] {
      for (std::size_t i = 0; i < builds; ++i) {
        runner.run(mesh);
      }
    });
  }
  works.emplace_back([&steps] { steps.done_one(); });
  const RaceRounds shared{
      .label = fmt::format("{}, level {}, {}", task.model->name, task.level, name(task.empty_side)),
      .rounds = rounds,
      .warm_up = rounds_of_each(process, kUncountedBuilds)};
  const std::vector<Timing> timings = time_in_turn(process, shared, steps.quiet(), works);
  std::vector<Race> races;
  for (std::size_t b = 0; b < kBuilders.size(); ++b) {
    Race& one = races.emplace_back(
        Race{task.model, task.level, task.empty_side, kBuilders[b], RaceHalf{}, RaceHalf{}});
    for (const std::size_t r : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t i = kRacedRules.size() * b + r;
      RacedBuilder& runner = runners[i];
      RaceHalf& racer = kRacedRules[r] == Rule::soms ? one.soms : one.spatial_median;
      racer.counts = statistics(runner.tree, runner.options);
      // A neutral builder tells for the library's, too: its last pair is that of `in_place`.
      const RacedBuilder& counted = runners[runners.size() - kRacedRules.size() + r];
      racer.work = runner.neutral ? runner.neutral->work()
                                  : BuildWork{.compared = counted.neutral->work().compared};
      racer.timing = per_build(timings[i], builds);
    }
  }
  return races;
}

Estimate gain(const Race& race) {
  return gain_of(race, 1);
}

Estimate gain_per_node(const Race& race) {
  return gain_of(race, static_cast<double>(race.spatial_median.counts.nodes) /
                           static_cast<double>(race.soms.counts.nodes));
}

double gain_in_work(const Race& race) {
  const auto spatial = static_cast<double>(race.spatial_median.work.compared);
  // Trees of the root alone compare nothing, by either rule.
  return spatial > 0 ? 100 * (1 - static_cast<double>(race.soms.work.compared) / spatial) : 0;
}

Table race_table(std::string id, std::string caption, std::span<const Race> races) {
  Table table{std::move(id), std::move(caption)};
  for (const char* const column : {"model", "builder", "rule", "empty_side", "level", "nodes",
                                   "compared", "outer", "inner", "merged", "rounds", "processes"}) {
    table.columns.push_back({column});
  }
  for (const char* const column : {"median", "low", "high"}) {
    table.columns.push_back({column, "ms", ColumnKind::timed});
  }
  for (const char* const column : {"gain", "gain_low", "gain_high", "gain_per_node",
                                   "gain_per_node_low", "gain_per_node_high"}) {
    table.columns.push_back({column, "%", ColumnKind::timed});
  }
  for (const Race& one : races) {
    table.rows.push_back(row_of(one, Rule::spatial_median));
    table.rows.push_back(row_of(one, Rule::soms));
  }
  return table;
}

const Race* find_race(std::span<const Race> races, const RaceTask& task, Builder builder) {
  const auto found = std::find_if(races.begin(), races.end(), [&](const Race& one) {
    return one.model == task.model && one.level == task.level &&
           one.empty_side == task.empty_side && one.builder == builder;
  });
  return found == races.end() ? nullptr : &*found;
}

}  // namespace soms::reproduce
