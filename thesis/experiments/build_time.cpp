// Figures 5.2 to 5.5 and tables 5.1, 5.6 and 5.8: how long a build takes.
#include "apps/draw/chart.h"
#include "apps/draw/grouped_bars.h"
#include "thesis/experiments/experiments.h"
#include "thesis/run/steps.h"
#include "thesis/trees/build_times.h"

#include <fmt/format.h>

#include <utility>

namespace soms::reproduce {

namespace {

/// What the bars of a chart show.
enum class Unit { milliseconds, per_node, per_thousand_triangles };

/// What one of these experiments varies.
struct TimedTask {
  std::string id;
  std::string caption;  ///< how the level is chosen
  std::string title;    ///< of the chart
  std::span<const Model> models;
  int repetitions = 0;  ///< in a whole run
  RepetitionsOf whose = RepetitionsOf::ours;
  bool average = false;  ///< the thesis' caption speaks of an average time
  Unit unit = Unit::milliseconds;
};

std::string_view unit_label(Unit unit) {
  switch (unit) {
    case Unit::per_node:
      return "us for a node";
    case Unit::per_thousand_triangles:
      return "us for 1,000 triangles";
    case Unit::milliseconds:
      break;
  }
  return "ms";
}

/// What a millisecond of this build counts in the unit of the chart.
double factor(const Counted& counted, Unit unit) {
  switch (unit) {
    case Unit::per_node:
      return 1e3 / static_cast<double>(counted.counts.nodes);
    case Unit::per_thousand_triangles:
      return 1e6 / static_cast<double>(counted.model->mesh->triangles.size());
    case Unit::milliseconds:
      break;
  }
  return 1;
}

/// Builds of one model at one level: a group of bars.
std::vector<Datum> data_of(std::span<const TimedBuild> builds, Unit unit) {
  std::vector<Datum> data;
  const Counted& first = builds.front().counted;
  const std::string group =
      fmt::format("{}, level {}", label_of(*first.model), first.contender.options.level);
  for (const TimedBuild& one : builds) {
    const double f = factor(one.counted, unit);
    const Timing& t = one.timing;
    data.push_back({group, one.counted.contender.title, f * t.median, f * t.lower_quartile,
                    f * t.upper_quartile});
  }
  return data;
}

/// Times all builds of each model at the level that `level_of` gives. Fills in table and chart.
std::vector<TimedBuild> time_task(const TimedTask& task, const Context& context,
                                  int (*level_of)(const Model&, const Limits&), Result& result) {
  std::size_t count = 0;
  for (const Model& model : task.models) {
    count += rounds(repetitions(context, task.repetitions, model));
  }
  Steps steps(context.limits, count);
  std::vector<TimedBuild> all;
  std::vector<Datum> data;
  for (const Model& model : task.models) {
    const std::vector<Contender> contenders = all_builds(level_of(model, steps.quiet()));
    const std::vector<TimedBuild> builds =
        time_builds(model, contenders, repetitions(context, task.repetitions, model), steps);
    const std::vector<Datum> of_model = data_of(builds, task.unit);
    data.insert(data.end(), of_model.begin(), of_model.end());
    all.insert(all.end(), builds.begin(), builds.end());
  }
  const std::string caption =
      fmt::format("{}{}{}{}", task.caption,
                  words_on_repetitions(context, task.repetitions, task.whose, task.models),
                  kThesisOptions, note_on_stand_ins(task.models));
  result.tables.push_back(time_table(task.id, caption, all));
  BarChart chart = grouped_bars(task.title, std::string(unit_label(task.unit)), data);
  chart.y_scale = task.unit == Unit::per_node ? Scale::log : Scale::linear;
  result.figures.push_back(
      {.id = task.id,
       .caption = fmt::format("{} Bars are medians, whiskers quartiles{}; the library's own builds "
                              "have their own options and no limit of levels.",
                              caption,
                              task.average ? ", where the thesis' caption says average: the table "
                                             "has both"
                                           : ""),
       .svg = draw(chart),
       .timed = true});
  result.remarks.emplace_back(kWhoseTimes);
  return all;
}

template <Rule rule, int level>
int balanced_level_of(const Model& model, const Limits& limits) {
  for (const Contender& contender : thesis_rules(level)) {
    if (contender.options.rule == rule) {
      return balanced_level(model, contender, limits);
    }
  }
  return level;
}

template <int level>
int fixed_level(const Model& /*model*/, const Limits& /*limits*/) {
  return level;
}

}  // namespace

Result figure_5_2(const Context& context) {
  Result result;
  time_task({.id = "figure_5_2",
             .caption = "Build time, every object at the balanced level of spatial median.",
             .title = "Build time at the balanced level of spatial median",
             .models = context.models.objects,
             .repetitions = 1000,
             .average = true,
             .unit = Unit::per_thousand_triangles},
            context, balanced_level_of<Rule::spatial_median, kObjectLevel>, result);
  return result;
}

Result figure_5_3(const Context& context) {
  Result result;
  time_task({.id = "figure_5_3",
             .caption = "Build time, every object at the balanced level of SOMS.",
             .title = "Build time at the balanced level of SOMS",
             .models = context.models.objects,
             .repetitions = 1000,
             .average = true,
             .unit = Unit::per_thousand_triangles},
            context, balanced_level_of<Rule::soms, kObjectLevel>, result);
  return result;
}

Result table_5_1(const Context& context) {
  Result result;
  time_task({.id = "table_5_1",
             .caption = fmt::format("Build time and time for a node of the objects at level {}.",
                                    kObjectLevel),
             .title = fmt::format("Build time for a node, objects at level {}", kObjectLevel),
             .models = context.models.objects,
             .repetitions = 100,
             .unit = Unit::per_node},
            context, fixed_level<kObjectLevel>, result);
  return result;
}

Result figure_5_4(const Context& context) {
  Result result;
  time_task({.id = "figure_5_4",
             .caption = "Build time, every urban scene at the balanced level of spatial median.",
             .title = "Urban scenes at the balanced level of spatial median",
             .models = context.models.scenes,
             .repetitions = 1000,
             .whose = RepetitionsOf::thesis,
             .average = true},
            context, balanced_level_of<Rule::spatial_median, kSceneLevel>, result);
  return result;
}

Result figure_5_5(const Context& context) {
  Result result;
  time_task({.id = "figure_5_5",
             .caption = "Build time of the urban scenes at level 7.",
             .title = "Urban scenes at level 7",
             .models = context.models.scenes,
             .repetitions = 1000,
             .whose = RepetitionsOf::thesis,
             .average = true},
            context, fixed_level<7>, result);
  return result;
}

Result table_5_6(const Context& context) {
  Result result;
  time_task({.id = "table_5_6",
             .caption = fmt::format(
                 "Build time and time for a node of the urban scenes at level {}.", kSceneLevel),
             .title = fmt::format("Build time for a node, urban scenes at level {}", kSceneLevel),
             .models = context.models.scenes,
             .repetitions = 100,
             .unit = Unit::per_node},
            context, fixed_level<kSceneLevel>, result);
  return result;
}

Result table_5_8(const Context& context) {
  Result result;
  time_task({.id = "table_5_8",
             .caption = "Build time of the urban scenes at level 12.",
             .title = "Urban scenes at level 12",
             .models = context.models.scenes,
             .repetitions = 100,
             .whose = RepetitionsOf::thesis,
             .average = true},
            context, fixed_level<12>, result);
  return result;
}

}  // namespace soms::reproduce
