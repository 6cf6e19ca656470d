#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/generate/spread.h"
#include "soms/generate/urban.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/slow_build.h"
#include "thesis/claims/comparison.h"
#include "thesis/experiments/experiments.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace soms::reproduce {
namespace {

Model titled_model(std::string name, Mesh mesh) {
  Model model{.name = std::move(name), .title = "a test's", .stand_in = true};
  model.hash = corner_hash(mesh);
  model.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return model;
}

Models beyond_models() {
  Models models;
  models.objects.push_back(titled_model("knot", generate_knot(600)));
  models.scenes.push_back(
      titled_model("unlike", generate_spread({.triangles = 800, .ratio = 1000, .size = 400})));
  return models;
}

Result run_beyond(Result (*experiment)(const Context&), const Models& models) {
  return experiment({.models = models, .quick = true});
}

/// The counted columns of all tables, and the figures that show no times.
std::string counted_rows(const Result& result) {
  std::string text;
  for (Table table : result.tables) {
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      if (table.columns[k].kind == ColumnKind::timed) {
        for (auto& row : table.rows) {
          row[k] = {};
        }
      }
    }
    text += to_csv(table);
  }
  for (const Figure& figure : result.figures) {
    text += figure.id + figure.caption + (figure.timed ? "" : figure.svg);
  }
  for (const std::string& remark : result.remarks) {
    text += remark + '\n';
  }
  return text;
}

const Table& table_named(const Result& result, std::string_view id) {
  const auto at = std::find_if(result.tables.begin(), result.tables.end(),
                               [&](const Table& table) { return table.id == id; });
  EXPECT_NE(at, result.tables.end()) << id;
  return *at;
}

std::size_t column_index(const Table& table, std::string_view name) {
  const auto at = std::find_if(table.columns.begin(), table.columns.end(),
                               [&](const Column& c) { return c.name == name; });
  EXPECT_NE(at, table.columns.end()) << name;
  return static_cast<std::size_t>(at - table.columns.begin());
}

double number(const Table& table, std::size_t row, std::string_view name) {
  const Cell& cell = table.rows.at(row).at(column_index(table, name));
  const auto* count = std::get_if<std::int64_t>(&cell);
  return count != nullptr ? static_cast<double>(*count) : std::get<double>(cell);
}

std::string word(const Table& table, std::size_t row, std::string_view name) {
  return std::get<std::string>(table.rows.at(row).at(column_index(table, name)));
}

/// Rows of the sweep for a rule, in the order of the spread.
std::vector<std::size_t> rows_of(const Table& table, std::string_view rule,
                                 std::string_view empty_side) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (word(table, i, "rule") == rule && word(table, i, "empty_side") == empty_side) {
      rows.push_back(i);
    }
  }
  return rows;
}

TEST(Beyond, CountedResultsAreTheSameInTwoRuns) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = beyond_models();
  const auto experiments =
      test::kSlowBuild ? std::vector{spread} : std::vector{modern, cities, spread};
  for (const auto experiment : experiments) {
    const Result result = run_beyond(experiment, models);
    EXPECT_FALSE(result.tables.empty());
    EXPECT_FALSE(result.remarks.empty());
    EXPECT_EQ(counted_rows(result), counted_rows(run_beyond(experiment, models)));
  }
}

TEST(Beyond, EveryRuleIsBuiltWithTheProductsOptionsAndThoseOfTheThesisWithItsOwn) {
  const auto builds = compared_builds(13, false);
  for (const RuleEntry& rule : rules()) {
    const bool there = std::any_of(builds.begin(), builds.end(), [&](const ComparedBuild& b) {
      return b.rule == rule.name && b.options == "product" &&
             b.build == BuildOptions{.rule = rule.rule};
    });
    EXPECT_TRUE(there) << rule.name;
  }
  const auto of_thesis = std::count_if(builds.begin(), builds.end(), [](const ComparedBuild& b) {
    return b.options == "thesis" && b.build == thesis_options(b.build.rule, 13);
  });
  EXPECT_EQ(of_thesis, 4);
  EXPECT_LT(compared_builds(13, true).size(), builds.size());
}

TEST(Beyond, AnswersOfAllBuildsAreEqualAndWorkIsCounted) {
  const Model scene = titled_model("plain", generate_urban(UrbanScene::plain));
  const Workload workload =
      make_workload(*scene.mesh, generate_mover(MoverKind::car), "car", 10, 40);
  const Compared compared = compare(scene, compared_builds(13, false), workload, 1, {});
  const Measured& first = compared.builds.front();
  EXPECT_GT(first.hits, 0U);
  EXPECT_LT(first.hits, compared.queries);
  for (const Measured& m : compared.builds) {
    SCOPED_TRACE(m.build.rule + " " + m.build.options);
    EXPECT_EQ(m.hits, first.hits);
    EXPECT_EQ(m.pairs, first.pairs);
    EXPECT_GT(m.all.node_tests, m.any.node_tests);
    EXPECT_GT(m.build_ms.median, 0);
    EXPECT_EQ(m.mesh_bytes, first.mesh_bytes);
    EXPECT_GT(m.layout_bytes, 40 * compared.triangles);
    EXPECT_LT(m.layout_bytes, 1000 * compared.triangles);
  }
}

TEST(Beyond, ExpectedVisitsAreMetByCubesDrawnEvenly) {
  const Model model = titled_model("knot", generate_knot(600));
  const Workload workload =
      make_workload(*model.mesh, generate_mover(MoverKind::drone), "drone", 20'000, 1);
  const Compared compared = compare(model, compared_builds(15, true), workload, 1, {});
  for (const Measured& m : compared.builds) {
    for (const Measured::AtSide& s : m.sides) {
      EXPECT_NEAR(s.anywhere.nodes, s.expected.nodes, 0.03 * s.expected.nodes) << m.build.rule;
      EXPECT_GT(looks(s.near), looks(s.anywhere));
    }
  }
}

TEST(Beyond, CubesAnywhereMeetTheModelsBoxAndThoseNearItAreWithinASide) {
  const Mesh mesh = generate_knot(200);
  const Workload workload = make_workload(mesh, generate_mover(MoverKind::drone), "drone", 200, 50);
  ASSERT_EQ(workload.cubes.size(), 3U);
  const Box whole = bounds(mesh);
  for (const Workload::Cubes& cubes : workload.cubes) {
    EXPECT_TRUE(std::all_of(cubes.anywhere.begin(), cubes.anywhere.end(),
                            [&](const Box& cube) { return overlaps(cube, whole); }));
    const Box reach{whole.lower - cubes.size, whole.upper + cubes.size};
    for (const Box& cube : cubes.near) {
      EXPECT_TRUE(reach.contains({cube.center(), cube.center()}));
      EXPECT_NEAR(cube.extent().y, cubes.size.y, 1e-12);
    }
  }
  EXPECT_EQ(workload.cubes[0].near.size(), 200U);
  EXPECT_EQ(workload.poses.size(), 50U);
  for (const Pose& pose : workload.poses) {
    EXPECT_NO_THROW(check(pose));
  }
}

TEST(Beyond, SpreadOfSizesIsInDecades) {
  EXPECT_NEAR(spread_of_sizes(generate_spread({.triangles = 10'000, .ratio = 1})), 0, 1e-9);
  // 90 % of a logarithmic scale of four decades.
  EXPECT_NEAR(spread_of_sizes(generate_spread({.triangles = 10'000, .ratio = 1e4})), 3.6, 0.01);
  EXPECT_EQ(spread_of_sizes(Mesh{}), 0);
}

TEST(Beyond, TheSweepsMessageFollowsFromItsTable) {
  const Result result = run_beyond(spread, Models{});
  const Table& table = table_named(result, "spread");
  const auto soms = rows_of(table, "soms", "");
  ASSERT_EQ(soms.size(), 5U);
  const auto percent = [&](std::size_t row) {
    return std::lround(100 * (number(table, row, "visits_over_sah") - 1));
  };
  ASSERT_GT(percent(soms.back()), percent(soms.front()));
  const auto second_look = rows_of(table, "soms_sah", "");
  EXPECT_LT(percent(second_look.back()) - percent(second_look.front()), 5);
  for (const char* const rule : {"soms", "object_median", "object_mean", "spatial_median"}) {
    for (const char* const empty_side : {"", "stop", "next_axis", "object_median"}) {
      const auto rows = rows_of(table, rule, empty_side);
      EXPECT_TRUE(rows.empty() || percent(rows.back()) - percent(rows.front()) >= 5)
          << rule << empty_side;
    }
  }
  const std::string title =
      "Compared to SAH, unlike triangles hurt every rule but SOMS with a second look";
  const Figure& figure = result.figures.at(0);
  EXPECT_NE(figure.svg.find(title), std::string::npos);
  EXPECT_NE(figure.caption.find(title), std::string::npos);
  const std::string share =
      fmt::format("SOMS {} %, {} %;", percent(soms.front()), percent(soms.back()));
  EXPECT_NE(figure.caption.find(share), std::string::npos) << figure.caption;
  for (const std::size_t row : rows_of(table, "sah", "")) {
    EXPECT_EQ(number(table, row, "visits_over_sah"), 1);
  }
}

TEST(Beyond, SpatialMedianStopsMoreOftenOnUnlikeTrianglesAndSomsNever) {
  const Result result = run_beyond(spread, Models{});
  const Table& table = table_named(result, "spread");
  const auto stop = rows_of(table, "spatial_median", "stop");
  const auto soms = rows_of(table, "soms", "");
  EXPECT_GT(number(table, stop.back(), "undividable"),
            2 * number(table, stop.front(), "undividable") + 10);
  EXPECT_EQ(number(table, soms.back(), "undividable"), 0);
  EXPECT_LT(number(table, soms.back(), "visits_over_sah"),
            number(table, stop.back(), "visits_over_sah"));
}

TEST(Beyond, WithoutCitiesAGeneratedOneIsUsedAndSaysHowToGiveOne) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Result result = run_beyond(cities, Models{});
  EXPECT_EQ(word(table_named(result, "cities_models"), 0, "model"), "generated_city");
  EXPECT_NE(result.remarks.back().find("--models"), std::string::npos);
}

TEST(Beyond, AQuickRunTakesTheTwoSmallestCitiesAndSaysSo) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models;
  for (const std::uint64_t triangles : {100U, 200U, 400U}) {
    models.cities.push_back(
        titled_model(fmt::format("city_{}", triangles), generate_knot(triangles)));
  }
  const Result result = run_beyond(cities, models);
  EXPECT_EQ(table_named(result, "cities_models").rows.size(), 2U);
  EXPECT_NE(result.remarks.back().find("2 smallest of 3"), std::string::npos);
}

TEST(Beyond, AStopRequestEndsAnExperiment) {
  const Models models = beyond_models();
  std::stop_source source;
  source.request_stop();
  for (const auto experiment : {modern, cities, spread}) {
    try {
      experiment({.models = models, .quick = true, .limits = {1, source.get_token(), {}}});
      ADD_FAILURE() << "not stopped";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
    }
  }
}

}  // namespace
}  // namespace soms::reproduce
