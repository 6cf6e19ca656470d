// Tables 5.2 and 5.7: how the build time grows from level to level.
#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/steps.h"
#include "thesis/trees/build_times.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <utility>

namespace soms::reproduce {

namespace {

/// The rules of the thesis and SAH: those that a greatest level limits.
std::vector<Contender> limited_builds(int level) {
  std::vector<Contender> builds = all_builds(level);
  std::erase_if(builds, [](const Contender& one) { return one.options.level == 0; });
  return builds;
}

/// Median of the same rule's build at another level; 0 at level 0.
double median_at(std::span<const TimedBuild> builds, const TimedBuild& like, int level) {
  for (const TimedBuild& one : builds) {
    if (one.counted.contender.name == like.counted.contender.name &&
        one.counted.contender.options.level == level) {
      return one.timing.median;
    }
  }
  return 0;
}

void add_rows(Table& table, std::span<const TimedBuild> builds, int greatest) {
  for (const TimedBuild& one : builds) {
    const int level = one.counted.contender.options.level;
    const double whole = median_at(builds, one, greatest);
    const double before = median_at(builds, one, level - 1);
    std::vector<Cell> row = cells_of(one.counted, kBuildColumns);
    row.emplace_back(std::int64_t{one.timing.repetitions});
    for (const double value :
         {one.timing.median, one.timing.lower_quartile, one.timing.upper_quartile,
          100 * (one.timing.median - before) / whole, 100 * one.timing.median / whole}) {
      row.emplace_back(value);
    }
    const std::vector<Cell> options = cells_of(one.counted, kBuildOptionColumns);
    row.insert(row.end(), options.begin(), options.end());
    table.rows.push_back(std::move(row));
  }
}

LineChart chart_of(const Model& model, std::span<const TimedBuild> builds,
                   std::span<const Contender> rules) {
  LineChart chart{.title = fmt::format("Build time by greatest level: {}", label_of(model)),
                  .x_label = "greatest level",
                  .y_label = "ms"};
  for (const Contender& rule : rules) {
    Line line{.name = rule.title, .dashed = !rule.of_thesis};
    for (const TimedBuild& one : builds) {
      if (one.counted.contender.name == rule.name) {
        line.x.push_back(one.counted.contender.options.level);
        line.y.push_back(one.timing.median);
        line.low.push_back(one.timing.lower_quartile);
        line.high.push_back(one.timing.upper_quartile);
      }
    }
    chart.lines.push_back(std::move(line));
  }
  return chart;
}

Result by_level(const Context& context, const std::string& id, std::span<const Model> models,
                int greatest) {
  constexpr int kWhole = 100;
  const std::vector<Contender> contenders = at_every_level(greatest, limited_builds);
  const std::string caption = fmt::format(
      "Build time by greatest level; percentages are of the median at level {}: of_level is what "
      "the level adds to the one before, up_to_level all so far.{}{}{}",
      greatest, words_on_repetitions(context, kWhole, RepetitionsOf::ours, models), kThesisOptions,
      note_on_stand_ins(models));
  Table table{.id = id, .caption = caption, .columns = columns_of(kBuildColumns)};
  table.columns.push_back({"builds"});
  for (const char* const name : {"median", "lower_quartile", "upper_quartile"}) {
    table.columns.push_back({name, "ms", ColumnKind::timed});
  }
  table.columns.push_back({"of_level", "%", ColumnKind::timed});
  table.columns.push_back({"up_to_level", "%", ColumnKind::timed});
  const std::vector<Column> last = columns_of(kBuildOptionColumns);
  table.columns.insert(table.columns.end(), last.begin(), last.end());
  Result result;
  std::size_t count = 0;
  for (const Model& model : models) {
    count += rounds(repetitions(context, kWhole, model));
  }
  Steps steps(context.limits, count);
  for (const Model& model : models) {
    const std::vector<TimedBuild> builds =
        time_builds(model, contenders, repetitions(context, kWhole, model), steps);
    add_rows(table, builds, greatest);
    result.figures.push_back(
        {.id = fmt::format("{}_{}", id, result.figures.size() + 1),
         .caption = fmt::format("Build time of {} by greatest level, medians and quartiles.{}",
                                label_of(model), kThesisOptions),
         .svg = draw(chart_of(model, builds, limited_builds(greatest))),
         .timed = true});
  }
  result.tables.push_back(std::move(table));
  result.remarks.emplace_back(kWhoseTimes);
  return result;
}

}  // namespace

Result table_5_2(const Context& context) {
  return by_level(context, "table_5_2", context.models.objects, kObjectLevel);
}

Result table_5_7(const Context& context) {
  return by_level(context, "table_5_7", context.models.scenes, kSceneLevel);
}

}  // namespace soms::reproduce
