#include "soms/generate/spread.h"

#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"
#include "soms/tree/visits.h"

#include "apps/draw/chart.h"
#include "thesis/experiments/experiments.h"
#include "thesis/trips/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace soms::reproduce {

namespace {

constexpr double kSide = 1;  ///< of the cube that asks: a hundredth of the scene

/// A build of the sweep.
struct SweptBuild {
  std::string_view rule;
  std::string_view empty_side;  ///< "" where the rule does not fail here
  std::string_view title;
  BuildOptions build = {};
};

constexpr BuildOptions product(Rule rule, EmptySide empty_side = EmptySide::object_median) {
  return {.rule = rule, .empty_side = empty_side};
}

/// SAH comes first: the others are set against it.
constexpr std::array kSweptBuilds{
    SweptBuild{"sah", "", "SAH", product(Rule::sah)},
    SweptBuild{"soms", "", "SOMS", product(Rule::soms)},
    SweptBuild{"soms_sah", "", "SOMS with a second look", product(Rule::soms_sah)},
    SweptBuild{"object_median", "", "object median", product(Rule::object_median)},
    SweptBuild{"object_mean", "", "object mean", product(Rule::object_mean)},
    SweptBuild{"spatial_median", "stop", "spatial median, stops",
               product(Rule::spatial_median, EmptySide::stop)},
    SweptBuild{"spatial_median", "next_axis", "spatial median, goes on",
               product(Rule::spatial_median, EmptySide::next_axis)},
    SweptBuild{"spatial_median", "object_median", "spatial median, then object median",
               product(Rule::spatial_median)},
};

/// One build at one spread.
struct SpreadPoint {
  TreeStatistics counts = {};
  double sah_cost = 0;
  ExpectedVisits visits = {};
  Timing build_ms = {};

  [[nodiscard]] double visited() const { return visits.nodes + visits.triangles; }
};

/// All builds at one spread.
struct Step {
  double decades = 0;
  std::array<SpreadPoint, kSweptBuilds.size()> points = {};

  [[nodiscard]] double over_sah(std::size_t i) const {
    return points[i].visited() / points[0].visited();
  }
};

/// 10^(halves / 2), the same bits on every machine.
double power_of_ten(int halves) {
  double power = halves % 2 == 0 ? 1 : std::sqrt(10.0);
  for (int i = 0; i < halves / 2; ++i) {
    power *= 10;
  }
  return power;
}

Step measure(int half_decades, std::uint64_t triangles, int repetitions, const Limits& limits) {
  const Mesh mesh = generate_spread({.triangles = triangles, .ratio = power_of_ten(half_decades)});
  Step step{.decades = 0.5 * half_decades};
  std::vector<std::function<void()>> works;
  for (std::size_t i = 0; i < kSweptBuilds.size(); ++i) {
    const BuildOptions& options = kSweptBuilds[i].build;
    const Tree tree = build(mesh, options, limits);
    step.points[i] = {.counts = statistics(tree, options),
                      .sah_cost = sah_cost(tree),
                      .visits = expected_visits(tree, {kSide, kSide, kSide})};
    works.emplace_back([&] { static_cast<void>(build(mesh, options, limits)); });
  }
  const std::vector<Timing> timings = time_in_turn(repetitions, limits, works, 1);
  for (std::size_t i = 0; i < timings.size(); ++i) {
    step.points[i].build_ms = timings[i];
  }
  return step;
}

Table table_of(const std::vector<Step>& steps, std::uint64_t triangles) {
  Table table{
      .id = "spread",
      .caption = fmt::format(
          "{} triangles in a flat scene, of the same places, directions and total area at "
          "every spread: only the decades between shortest and longest edge change. Visits "
          "expected of a cube of a hundredth of the scene's side; leaves of 8 triangles, no "
          "limit of levels.",
          triangles),
      .columns = {{"spread", "decades"},
                  {"rule"},
                  {"empty_side"},
                  {"nodes"},
                  {"leaves"},
                  {"largest_leaf"},
                  {"undividable"},
                  {"sah_cost"},
                  {"node_visits"},
                  {"triangle_visits"},
                  {"visits_over_sah"},
                  {"build", "ms", ColumnKind::timed}}};
  for (const Step& step : steps) {
    for (std::size_t i = 0; i < kSweptBuilds.size(); ++i) {
      const SpreadPoint& p = step.points[i];
      const auto count = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
      table.rows.push_back({step.decades, std::string(kSweptBuilds[i].rule),
                            std::string(kSweptBuilds[i].empty_side), count(p.counts.nodes),
                            count(p.counts.leaves), count(p.counts.largest_leaf),
                            count(p.counts.undividable), p.sah_cost, p.visits.nodes,
                            p.visits.triangles, step.over_sah(i), p.build_ms.median});
    }
  }
  return table;
}

std::size_t index_of(std::string_view rule, std::string_view empty_side = "") {
  const auto* const at = std::find_if(
      kSweptBuilds.begin(), kSweptBuilds.end(),
      [&](const SweptBuild& c) { return c.rule == rule && c.empty_side == empty_side; });
  return static_cast<std::size_t>(at - kSweptBuilds.begin());
}

int percent_over_sah(const Step& step, std::size_t i) {
  return static_cast<int>(std::lround(100 * (step.over_sah(i) - 1)));
}

/// Unlike triangles hurt a rule if they add at least so many points to its share over SAH.
constexpr int kHurtPoints = 5;

bool is_hurt(const std::vector<Step>& steps, std::size_t i) {
  return percent_over_sah(steps.back(), i) - percent_over_sah(steps.front(), i) >= kHurtPoints;
}

/// The message, from the two ends of the sweep.
std::string message(const std::vector<Step>& steps) {
  std::string spared;
  bool hurt = false;
  for (std::size_t i = 1; i < kSweptBuilds.size(); ++i) {
    if (is_hurt(steps, i)) {
      hurt = true;
    } else {
      spared += fmt::format("{}{}", spared.empty() ? "" : "; ", kSweptBuilds[i].title);
    }
  }
  if (!hurt) {
    return "Compared to SAH, unlike triangles hurt no rule";
  }
  return "Compared to SAH, unlike triangles hurt every rule" +
         (spared.empty() ? spared : " but " + spared);
}

/// The shares behind the message.
std::string shares(const std::vector<Step>& steps) {
  std::string words;
  for (std::size_t i = 1; i < kSweptBuilds.size(); ++i) {
    words += fmt::format("{} {} {} %, {} %", i == 1 ? "" : ";", kSweptBuilds[i].title,
                         percent_over_sah(steps.front(), i), percent_over_sah(steps.back(), i));
  }
  return fmt::format("At both ends:{}. Hurt means: by {} points or more (ours).", words,
                     kHurtPoints);
}

Figure figure_of(const std::vector<Step>& steps) {
  LineChart chart{.title = message(steps),
                  .x_label = "spread of triangle sizes: decades from shortest to longest edge",
                  .y_label = "more nodes and triangles visited than with SAH, %"};
  const Step& last = steps.back();
  const auto add = [&](std::size_t i, bool dashed) {
    Line line{.name = std::string(kSweptBuilds[i].title), .dashed = dashed};
    for (const Step& step : steps) {
      line.x.push_back(step.decades);
      line.y.push_back(100 * (step.over_sah(i) - 1));
    }
    if (!dashed) {
      chart.callouts.push_back(
          {line.x.back(), line.y.back(), fmt::format("{:+} %", percent_over_sah(last, i))});
    }
    chart.lines.push_back(std::move(line));
  };
  add(index_of("spatial_median", "stop"), false);
  add(index_of("spatial_median", "next_axis"), true);
  add(index_of("soms"), false);
  add(index_of("soms_sah"), false);
  return {.id = "spread",
          .caption = fmt::format("{}. Expected nodes and triangles that a cube of a hundredth of "
                                 "the scene's side visits; SAH is the zero line. {}",
                                 message(steps), shares(steps)),
          .svg = draw(chart)};
}

/// "1 % fewer nodes and triangles", of a ratio of those that are visited.
std::string more_or_fewer(double ratio) {
  const long percent = std::lround(100 * (ratio - 1));
  return percent == 0 ? "as many nodes and triangles"
                      : fmt::format("{} % {} nodes and triangles", std::abs(percent),
                                    percent > 0 ? "more" : "fewer");
}

/// Where SOMS stands against another build over the sweep.
std::string against(const std::vector<Step>& steps, std::size_t other) {
  const std::size_t soms = index_of("soms");
  const auto percent = [&](const Step& step) {
    const double ratio = step.points[soms].visited() / step.points[other].visited();
    return more_or_fewer(ratio);
  };
  return fmt::format(
      "Against {} SOMS visits {} where all triangles are alike, and {} over {} decades.",
      kSweptBuilds[other].title, percent(steps.front()), percent(steps.back()),
      steps.back().decades);
}

}  // namespace

Result spread(const Context& context) {
  const Limits alone = context.limits.alone();
  const std::uint64_t triangles = context.quick ? 5000 : 20'000;
  constexpr int kLast = 8;
  std::vector<Step> steps;
  for (int halves = 0; halves <= kLast; halves += context.quick ? 2 : 1) {
    check_stop(context.limits);
    steps.push_back(measure(halves, triangles, context.repetitions(30), alone));
    if (context.limits.progress) {
      context.limits.progress((halves + 1.0) / (kLast + 1));
    }
  }
  Result result{.tables = {table_of(steps, triangles)}, .figures = {figure_of(steps)}};
  for (std::size_t i = 0; i < kSweptBuilds.size(); ++i) {
    if (i != index_of("soms")) {
      result.remarks.push_back(against(steps, i));
    }
  }
  return result;
}

}  // namespace soms::reproduce
