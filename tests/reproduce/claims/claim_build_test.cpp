#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"

#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/tree/inputs.h"
#include "thesis/experiments/experiments.h"
#include "thesis/trees/build_race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soms::reproduce {
namespace {

constexpr std::array kBuildClaims{"claim-build-8-percent", "claim-build-43-ms", "claim-build-city"};

TEST(ClaimBuild, RunsAgreeButForTimes) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = trips::small_models();
  for (const char* const item : kBuildClaims) {
    const Result first = trips::run_quick(item, models);
    const Result second = trips::run_quick(item, models);
    ASSERT_EQ(first.claims.size(), 1U) << item;
    ASSERT_EQ(first.tables.size(), second.tables.size());
    for (std::size_t i = 0; i < first.tables.size(); ++i) {
      EXPECT_EQ(trips::masked_csv(first.tables[i]), trips::masked_csv(second.tables[i]));
    }
    for (const Figure& figure : first.figures) {
      EXPECT_TRUE(figure.timed) << figure.id;
    }
    EXPECT_TRUE(is_timed(first.claims[0]));
  }
}

TEST(ClaimBuild, OnlyTheObjectOf948TrianglesIsJudged) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = trips::small_models();
  const auto verdict = [&](const char* item) {
    return verdict_of(trips::run_quick(item, models).claims.at(0));
  };
  EXPECT_EQ(verdict("claim-build-8-percent"), Verdict::cannot_be_checked);
  models.objects.front().stand_in = false;
  EXPECT_EQ(verdict("claim-build-8-percent"), Verdict::cannot_be_checked);
  models.objects.front().mesh = std::make_shared<const Mesh>(generate_knot(948));
  EXPECT_EQ(verdict("claim-build-43-ms"), Verdict::cannot_be_checked);
}

TEST(ClaimBuild, EightPercentIsReadInTwoWays) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = trips::small_models();
  models.objects.front().stand_in = false;
  models.objects.front().mesh = std::make_shared<const Mesh>(generate_knot(948));
  const Claim claim = trips::run_quick("claim-build-8-percent", models).claims.at(0);
  const auto rows_where = [&](const auto& is) {
    return std::count_if(claim.rows.begin(), claim.rows.end(), is);
  };
  // Builders; five levels, with the balanced one among them, and three fallbacks at the last.
  constexpr std::ptrdiff_t kOfTrees = 3 * (5 + 3);
  EXPECT_EQ(rows_where([](const ClaimRow& row) {
              return row.unjudged.empty() && row.reading.ends_with("; at least 8 % (7.5)") &&
                     row.demand.above == 7.5 && std::isinf(row.demand.below);
            }),
            kOfTrees);
  EXPECT_EQ(rows_where([](const ClaimRow& row) {
              return row.unjudged.empty() &&
                     row.reading.ends_with("; about 8 %, within 5 points (ours)") &&
                     row.demand.above == 3 && row.demand.below == 13;
            }),
            kOfTrees);
  EXPECT_EQ(rows_where([](const ClaimRow& row) {
              return row.metric == "time for a node, saved by SOMS" && !row.unjudged.empty();
            }),
            3);
  EXPECT_EQ(claim.rows.size(), 2 * kOfTrees + 3);
  EXPECT_EQ(rows_where([](const ClaimRow& row) { return row.rounds == 30; }), 2 * kOfTrees + 3);
  EXPECT_EQ(rows_where([&](const ClaimRow& row) { return is_nearest(claim, row); }), 1);
  EXPECT_EQ(rows_where([](const ClaimRow& row) {
              return row.reading.starts_with("library's builder, gives spatial median one pass");
            }),
            (2 * kOfTrees + 3) / 3);
}

TEST(ClaimBuild, EveryRaceOfTheCityHasItsRowsOnce) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = trips::small_models();
  models.scenes.front().mesh = std::make_shared<const Mesh>(generate_urban(UrbanScene::boxes));
  const Result result = trips::run_quick("claim-build-city", models);
  const Claim& claim = result.claims.at(0);
  // A race has a row of counts and one for each builder; in the table one for builder and rule.
  const std::size_t races = trips::table_of(result, "build_city").rows.size() / 6;
  EXPECT_EQ(claim.rows.size(), 4 * races);
  std::set<std::array<std::string, 3>> seen;
  for (const ClaimRow& row : claim.rows) {
    EXPECT_TRUE(seen.insert({row.reading, row.metric, row.subject}).second) << row.reading;
    EXPECT_EQ(row.unjudged.empty(), row.interval.has_value());
  }
  // One scene, by the one builder that the captions describe.
  EXPECT_EQ(std::count_if(claim.rows.begin(), claim.rows.end(),
                          [&](const ClaimRow& row) { return is_nearest(claim, row); }),
            1);
}

TEST(ClaimBuild, ALevelThatTwoFiguresShareIsOneReading) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = trips::small_models();
  models.scenes.front().mesh = std::make_shared<const Mesh>(generate_urban(UrbanScene::mixed));
  const Claim claim = trips::run_quick("claim-build-city", models).claims.at(0);
  const auto has = [&](std::string_view reading) {
    return std::any_of(claim.rows.begin(), claim.rows.end(),
                       [&](const ClaimRow& row) { return row.reading == reading; });
  };
  EXPECT_TRUE(
      has("balanced level of spatial median (figure 5.4); a node stays whole where a side "
          "is empty"));
  EXPECT_TRUE(
      has("level 7 (figure 5.5; figure 5.4, too, where it is spatial median's balanced "
          "level); other axes where a side is empty"));
  EXPECT_FALSE(std::any_of(claim.rows.begin(), claim.rows.end(), [](const ClaimRow& row) {
    return row.reading.starts_with("balanced") &&
           row.reading.find("other axes") != std::string::npos;
  }));
}

TEST(ClaimBuild, TreesOfTheRootAloneAreNotJudged) {
  Models models = trips::small_models();
  models.scenes.front().mesh =
      std::make_shared<const Mesh>(soms::test::make_input(soms::test::Input::coincident, 20));
  const Claim claim = trips::run_quick("claim-build-city", models).claims.at(0);
  for (const ClaimRow& row : claim.rows) {
    EXPECT_TRUE(std::isfinite(row.value)) << row.reading;
    if (row.reading.find("stays whole") != std::string::npos) {
      EXPECT_FALSE(row.unjudged.empty()) << row.reading;
    }
  }
}

/// Nodes; midpoints compared; outer, inner and merged boxes.
using ClaimCounts = std::array<std::uint64_t, 5>;

ClaimCounts neutral_counts(const Mesh& mesh, NeutralWay way, Rule rule, int level,
                           EmptySide empty_side = EmptySide::stop) {
  BuildOptions options = thesis_options(rule, level);
  options.empty_side = empty_side;
  NeutralBuilder builder(way, options);
  const std::uint64_t nodes = builder.build(mesh).nodes.size();
  const BuildWork& work = builder.work();
  return {nodes, work.compared, work.outer, work.inner, work.merged};
}

TEST(ClaimBuild, GoldenWorkOnTheScenes) {
  const Mesh plain = generate_urban(UrbanScene::plain);
  const Mesh mixed = generate_urban(UrbanScene::mixed);
  const auto lists = NeutralWay::thesis_like;
  const auto in_place = NeutralWay::in_place;
  EXPECT_EQ(neutral_counts(plain, lists, Rule::spatial_median, 13),
            (ClaimCounts{2929, 65634, 66004, 0, 0}));
  EXPECT_EQ(neutral_counts(plain, lists, Rule::soms, 13),
            (ClaimCounts{6537, 67354, 73026, 67354, 0}));
  EXPECT_EQ(neutral_counts(plain, in_place, Rule::spatial_median, 13),
            (ClaimCounts{2929, 65634, 71306, 0, 0}));
  EXPECT_EQ(neutral_counts(plain, in_place, Rule::soms, 13),
            (ClaimCounts{6537, 67354, 5672, 73026, 3268}));
  EXPECT_EQ(neutral_counts(mixed, lists, Rule::spatial_median, 13),
            (ClaimCounts{3, 11344, 11344, 0, 0}));
  EXPECT_EQ(neutral_counts(mixed, lists, Rule::soms, 13),
            (ClaimCounts{6395, 67302, 72970, 67302, 0}));
  EXPECT_EQ(neutral_counts(mixed, in_place, Rule::soms, 7),
            (ClaimCounts{127, 34032, 5672, 39704, 63}));
  const auto chain = EmptySide::chain;
  EXPECT_EQ(neutral_counts(mixed, lists, Rule::spatial_median, 13, chain),
            (ClaimCounts{47, 68064, 73736, 0, 0}));
  EXPECT_EQ(neutral_counts(mixed, lists, Rule::soms, 13, chain),
            (ClaimCounts{6399, 67302, 72974, 67302, 0}));
  EXPECT_EQ(neutral_counts(plain, in_place, Rule::spatial_median, 13, chain),
            (ClaimCounts{6157, 67703, 73375, 0, 0}));
  EXPECT_EQ(neutral_counts(plain, in_place, Rule::soms, 13, chain),
            (ClaimCounts{6537, 67354, 5672, 73026, 3268}));
}

TEST(ClaimBuild, GoldenWorkOnTheBunny) {
  SOMS_NEEDS_OUTSIDE_DATA("work of 4 builds of the bunny");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  const Mesh& bunny = *models.objects.front().mesh;
  const auto lists = NeutralWay::thesis_like;
  const auto in_place = NeutralWay::in_place;
  EXPECT_EQ(neutral_counts(bunny, lists, Rule::spatial_median, 15),
            (ClaimCounts{1267, 9783, 10208, 0, 0}));
  EXPECT_EQ(neutral_counts(bunny, lists, Rule::soms, 15),
            (ClaimCounts{1847, 9857, 10761, 9857, 0}));
  EXPECT_EQ(neutral_counts(bunny, in_place, Rule::spatial_median, 15),
            (ClaimCounts{1267, 9783, 10731, 0, 0}));
  EXPECT_EQ(neutral_counts(bunny, in_place, Rule::soms, 15),
            (ClaimCounts{1847, 9857, 948, 10805, 923}));
  const auto chain = EmptySide::chain;
  EXPECT_EQ(neutral_counts(bunny, lists, Rule::spatial_median, 15, chain),
            (ClaimCounts{3091, 11565, 12513, 0, 0}));
  EXPECT_EQ(neutral_counts(bunny, lists, Rule::soms, 15, chain),
            (ClaimCounts{1983, 9962, 10910, 9962, 0}));
}

TEST(ClaimBuild, GainIsTimeSavedOverPairs) {
  Race race;
  race.spatial_median.timing.rounds = {1, 2, 1};
  race.soms.timing.rounds = {0.9, 1.8, 0.9};
  race.spatial_median.counts.nodes = 10;
  race.soms.counts.nodes = 15;
  EXPECT_NEAR(gain(race).value, 10, 1e-9);
  EXPECT_NEAR(gain_per_node(race).value, 40, 1e-9);
  race.soms.timing.rounds = {0.5, 1.8, 1.1};
  const Estimate spread = gain(race);
  EXPECT_NEAR(spread.value, 10, 1e-9);
  EXPECT_NEAR(spread.interval.low, -10, 1e-9);
  EXPECT_NEAR(spread.interval.high, 50, 1e-9);
}

}  // namespace
}  // namespace soms::reproduce
