#include "thesis/trees/build_times.h"

#include "soms/generate/shapes.h"

#include "tests/support/slow_build.h"
#include "thesis/experiments/experiments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>

namespace soms::reproduce {
namespace {

Model model_of(std::string name, Mesh mesh) {
  Model model;
  model.title = name;
  model.name = std::move(name);
  model.stand_in = true;
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

Models timed_models() {
  Models models;
  models.objects.push_back(model_of("knot", generate_knot(120)));
  models.objects.push_back(model_of("ball", generate_sphere(80)));
  models.scenes.push_back(model_of("town", generate_sphere(200)));
  return models;
}

constexpr std::array kTimed{figure_5_2, table_5_1, table_5_2, figure_5_3, figure_5_4,
                            figure_5_5, table_5_6, table_5_7, table_5_8};

std::size_t column(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const Column& one) { return one.name == name; });
  EXPECT_NE(found, table.columns.end()) << name;
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// The table as CSV with an empty cell for each time.
std::string counted_part(Table table) {
  for (std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (table.columns[i].kind == ColumnKind::timed) {
        row[i] = Cell{};
      }
    }
  }
  return to_csv(table);
}

TEST(BuildTimes, TimesAreMarkedAndTheRestIsTheSameInTwoRuns) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = timed_models();
  const Context context{.models = models, .quick = true};
  for (const auto run : kTimed) {
    const Result first = run(context);
    const Result second = run(context);
    ASSERT_EQ(first.tables.size(), 1U);
    const Table& table = first.tables.front();
    EXPECT_EQ(counted_part(table), counted_part(second.tables.at(0)));
    std::size_t timed = 0;
    for (const Column& column : table.columns) {
      const bool is_time = column.unit == "ms" || column.unit == "us" || column.unit == "%";
      EXPECT_EQ(is_time, column.kind == ColumnKind::timed) << table.id << " " << column.name;
      timed += is_time ? 1U : 0U;
    }
    EXPECT_GE(timed, 5U) << table.id;
    ASSERT_FALSE(first.figures.empty());
    for (const Figure& figure : first.figures) {
      EXPECT_TRUE(figure.timed) << figure.id;
    }
  }
}

TEST(BuildTimes, ShareOfTheGreatestLevelIsTheWholeAndLevelsAddUp) {
  const Models models = timed_models();
  const Table table = table_5_2({.models = models, .quick = true}).tables.front();
  const std::size_t up_to = column(table, "up_to_level");
  const std::size_t rule = column(table, "rule");
  const std::size_t level = column(table, "level");
  double sum = 0;
  std::size_t whole = 0;
  for (const std::vector<Cell>& row : table.rows) {
    if (std::get<std::string>(row[0]) == "knot" && std::get<std::string>(row[rule]) == "soms") {
      sum += std::get<double>(row[up_to - 1]);
      EXPECT_NEAR(sum, std::get<double>(row[up_to]), 1e-6);
    }
    if (std::get<std::int64_t>(row[level]) == kObjectLevel) {
      EXPECT_DOUBLE_EQ(std::get<double>(row[up_to]), 100);
      ++whole;
    }
  }
  EXPECT_NEAR(sum, 100, 1e-6);
  std::size_t limited = 0;
  for (const Contender& contender : all_builds(1)) {
    limited += contender.options.level > 0 ? 1U : 0U;
  }
  EXPECT_EQ(whole, 2 * limited);  // two objects
}

TEST(BuildTimes, PercentageIsAgainstSpatialMedianOfTheSameModelAndLevel) {
  const Model model = model_of("ball", generate_sphere(80));
  const auto build_of = [&](Rule rule, int level, double ms) {
    Contender contender{"rule", "rule", level > 0, thesis_options(rule, level)};
    TimedBuild build{{&model, contender, {}}, {}};
    build.counted.counts.nodes = 10;
    build.timing.median = ms;
    build.timing.mean = 2 * ms;
    build.timing.rounds = {0.5 * ms, ms, 3 * ms};
    return build;
  };
  const std::array builds{build_of(Rule::spatial_median, 5, 1), build_of(Rule::soms, 5, 0.9),
                          build_of(Rule::spatial_median, 6, 2), build_of(Rule::soms, 6, 3),
                          build_of(Rule::soms, 4, 1),           build_of(Rule::sah, 0, 4)};
  const Table table = time_table("t", "T", builds);
  const auto above = [&](std::size_t row) {
    return table.rows[row][column(table, "above_spatial_median")];
  };
  EXPECT_DOUBLE_EQ(std::get<double>(above(0)), 0);
  EXPECT_NEAR(std::get<double>(above(1)), -10, 1e-9);
  EXPECT_NEAR(std::get<double>(above(3)), 50, 1e-9);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(above(4)));
  EXPECT_NEAR(std::get<double>(above(5)), 100, 1e-9);  // to the greatest level timed
  const std::size_t per_node = column(table, "mean_per_node");
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][per_node]), 200);  // 2 ms over 10 nodes, in us
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][column(table, "low")]), 0.5);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[0][column(table, "high")]), 3);
}

TEST(BuildTimes, CaptionsTellOptionsAndWhoseTheRepetitionsAre) {
  const Models models = timed_models();
  const Context context{.models = models, .quick = true};
  for (const auto run : kTimed) {
    const Result result = run(context);
    const std::string& caption = result.tables.front().caption;
    const std::string& id = result.tables.front().id;
    EXPECT_NE(caption.find(kThesisOptions), std::string::npos) << caption;
    const bool of_thesis = id == "figure_5_4" || id == "figure_5_5" || id == "table_5_8";
    EXPECT_EQ(caption.find("a number of ours") == std::string::npos, of_thesis) << caption;
    const bool average = of_thesis || id == "figure_5_2" || id == "figure_5_3";
    EXPECT_EQ(result.figures.front().caption.find("caption says average") != std::string::npos,
              average)
        << result.figures.front().caption;
    for (const Figure& figure : result.figures) {
      EXPECT_NE(figure.caption.find(kThesisOptions), std::string::npos) << figure.id;
    }
  }
}

TEST(BuildTimes, WordsOnRepetitionsTellOfQuickRunsAndLargeModels) {
  const Models models;
  const std::array small{model_of("small", generate_sphere(80))};
  const std::array large{model_of("large", generate_knot(40'000))};
  EXPECT_EQ(words_on_repetitions({.models = models}, 1000, RepetitionsOf::thesis, small),
            " Each tree is built 1,000 times, the number of the thesis' caption.");
  EXPECT_EQ(
      words_on_repetitions({.models = models, .quick = true}, 100, RepetitionsOf::ours, large),
      " Each tree is built 10 times (100 in a whole run), a number of ours, for the thesis' "
      "caption "
      "names none; of a model of more than 10,000 triangles fewer times, see column builds.");
}

TEST(BuildTimes, LargeModelsAreBuiltFewerTimes) {
  const Models models;
  const Context whole{.models = models};
  const Context quick{.models = models, .quick = true};
  const Model small = model_of("small", generate_sphere(80));
  const Model large = model_of("large", generate_knot(40'000));
  EXPECT_EQ(repetitions(whole, 1000, small), 1000);
  EXPECT_EQ(repetitions(whole, 1000, large), 250);
  EXPECT_EQ(repetitions(quick, 1000, large), 25);
  EXPECT_EQ(repetitions(quick, 100, large), 5);
  EXPECT_EQ(repetitions(whole, 3, large), 3);
}

TEST(BuildTimes, ProgressEndsAtOne) {
  const Models models = timed_models();
  Context context{.models = models, .quick = true};
  double last = 0;
  bool ascends = true;
  context.limits.progress = [&](double share) {
    ascends = ascends && share >= last;
    last = share;
  };
  static_cast<void>(figure_5_4(context));
  EXPECT_TRUE(ascends);
  EXPECT_DOUBLE_EQ(last, 1);
}

}  // namespace
}  // namespace soms::reproduce
