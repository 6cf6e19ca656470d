#include "soms/generate/shapes.h"
#include "soms/generate/urban.h"

#include "reproduce/build_race.h"
#include "reproduce/experiments/experiments.h"
#include "tests/reproduce/trips.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

namespace soms::reproduce {
namespace {

constexpr std::array kClaims{"claim-build-8-percent", "claim-build-43-ms", "claim-build-city"};

TEST(ClaimBuild, RunsAgreeButForTimes) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const Models models = test::small_models();
  for (const char* const item : kClaims) {
    const Result first = test::run_quick(item, models);
    const Result second = test::run_quick(item, models);
    ASSERT_EQ(first.claims.size(), 1U) << item;
    ASSERT_EQ(first.tables.size(), second.tables.size());
    for (std::size_t i = 0; i < first.tables.size(); ++i) {
      EXPECT_EQ(test::masked_csv(first.tables[i]), test::masked_csv(second.tables[i]));
    }
    for (const Figure& figure : first.figures) {
      EXPECT_TRUE(figure.timed) << figure.id;
    }
    EXPECT_TRUE(is_timed(first.claims[0]));
  }
}

TEST(ClaimBuild, OnlyTheObjectOf948TrianglesIsJudged) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  Models models = test::small_models();
  const auto verdict = [&](const char* item) {
    return verdict_of(test::run_quick(item, models).claims.at(0));
  };
  EXPECT_EQ(verdict("claim-build-8-percent"), Verdict::cannot_be_checked);
  models.objects.front().stand_in = false;
  EXPECT_EQ(verdict("claim-build-8-percent"), Verdict::cannot_be_checked);
  models.objects.front().mesh = std::make_shared<const Mesh>(generate_knot(948));
  const Claim claim = test::run_quick("claim-build-8-percent", models).claims.at(0);
  const auto of_trees = std::count_if(claim.rows.begin(), claim.rows.end(), [](const auto& row) {
    return row.metric.starts_with("time of the tree");
  });
  EXPECT_EQ(of_trees, 3 * (12 + 2));  // builders; levels, and two fallbacks at the last
  // Mean nodes only where the trees differ in nodes, which those of few levels do not.
  EXPECT_GT(claim.rows.size(), 3U * (12U + 2U));
  EXPECT_LT(claim.rows.size(), 3U * 2U * (12U + 2U));
  for (const ClaimRow& row : claim.rows) {
    EXPECT_TRUE(row.unjudged.empty());
    EXPECT_EQ(row.rounds, 60);
    EXPECT_EQ(row.demand.above, 7.5);
  }
  EXPECT_EQ(verdict("claim-build-43-ms"), Verdict::cannot_be_checked);
}

/// Nodes; midpoints compared; outer, inner and merged boxes.
using Counts = std::array<std::uint64_t, 5>;

Counts counts_of(const Mesh& mesh, NeutralWay way, Rule rule, int level) {
  NeutralBuilder builder(way, thesis_options(rule, level));
  const std::uint64_t nodes = builder.build(mesh).nodes.size();
  const BuildWork& work = builder.work();
  return {nodes, work.compared, work.outer, work.inner, work.merged};
}

TEST(ClaimBuild, GoldenWorkOnTheScenes) {
  const Mesh plain = generate_urban(UrbanScene::plain);
  const Mesh mixed = generate_urban(UrbanScene::mixed);
  const auto lists = NeutralWay::thesis_like;
  const auto in_place = NeutralWay::in_place;
  EXPECT_EQ(counts_of(plain, lists, Rule::spatial_median, 13), (Counts{2929, 65634, 66004, 0, 0}));
  EXPECT_EQ(counts_of(plain, lists, Rule::soms, 13), (Counts{6537, 67354, 73026, 67354, 0}));
  EXPECT_EQ(counts_of(plain, in_place, Rule::spatial_median, 13),
            (Counts{2929, 65634, 71306, 0, 0}));
  EXPECT_EQ(counts_of(plain, in_place, Rule::soms, 13), (Counts{6537, 67354, 5672, 73026, 3268}));
  EXPECT_EQ(counts_of(mixed, lists, Rule::spatial_median, 13), (Counts{3, 11344, 11344, 0, 0}));
  EXPECT_EQ(counts_of(mixed, lists, Rule::soms, 13), (Counts{6395, 67302, 72970, 67302, 0}));
  EXPECT_EQ(counts_of(mixed, in_place, Rule::soms, 7), (Counts{127, 34032, 5672, 39704, 63}));
}

TEST(ClaimBuild, GoldenWorkOnTheBunny) {
  SOMS_NEEDS_OUTSIDE_DATA("work of 4 builds of the bunny");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  const Mesh& bunny = *models.objects.front().mesh;
  const auto lists = NeutralWay::thesis_like;
  const auto in_place = NeutralWay::in_place;
  EXPECT_EQ(counts_of(bunny, lists, Rule::spatial_median, 15), (Counts{1267, 9783, 10208, 0, 0}));
  EXPECT_EQ(counts_of(bunny, lists, Rule::soms, 15), (Counts{1847, 9857, 10761, 9857, 0}));
  EXPECT_EQ(counts_of(bunny, in_place, Rule::spatial_median, 15),
            (Counts{1267, 9783, 10731, 0, 0}));
  EXPECT_EQ(counts_of(bunny, in_place, Rule::soms, 15), (Counts{1847, 9857, 948, 10805, 923}));
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
