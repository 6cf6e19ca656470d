// Other readings of SOMS: what they count, by an independent implementation, and how they stand.
#include "soms/tree/build.h"
#include "soms/tree/statistics.h"

#include "reproduce/alternative_rules.h"
#include "reproduce/balance_measures.h"
#include "reproduce/experiments/experiments.h"
#include "reproduce/object_meshes.h"
#include "reproduce/stuck_nodes.h"
#include "reproduce/toy_sets.h"
#include "tests/reproduce/trips.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <string>

namespace soms::reproduce {
namespace {

using trips::cell;
using trips::table_of;

TreeStatistics counts_by(const Mesh& mesh, RuleFunction rule, AxisFrom axis, int level) {
  BuildOptions options = thesis_options(Rule::soms, level);
  options.axis_from = axis;
  return statistics(build_by(mesh, rule, options), options);
}

/// Leaves with one triangle, nodes and balanced level.
using Numbers = std::array<std::uint64_t, 3>;

Numbers pair_numbers(const Mesh& mesh, int level) {
  const TreeStatistics s = counts_by(mesh, middle_pair, AxisFrom::inner, level);
  return {s.one, s.nodes, s.balanced_level};
}

Numbers hybrid_numbers(const Mesh& mesh, int level) {
  const TreeStatistics s = counts_by(mesh, spatial_then_soms, AxisFrom::outer, level);
  return {s.one, s.nodes, s.balanced_level};
}

TEST(Readings, AlternativeRulesOnTheScenesAreGolden) {
  const Models models = find_models({}, {.scenes = true});
  constexpr std::array<Numbers, 3> kPair{{{2337, 7865, 12}, {2306, 7805, 12}, {2332, 7839, 12}}};
  constexpr std::array<Numbers, 3> kHybrid{{{1865, 6189, 9}, {1941, 6459, 10}, {1867, 6311, 10}}};
  for (std::size_t i = 0; i < models.scenes.size(); ++i) {
    EXPECT_EQ(pair_numbers(*models.scenes[i].mesh, 13), kPair.at(i)) << models.scenes[i].name;
    EXPECT_EQ(hybrid_numbers(*models.scenes[i].mesh, 13), kHybrid.at(i)) << models.scenes[i].name;
  }
}

TEST(Readings, AlternativeRulesOnTheBunnyAreGolden) {
  SOMS_NEEDS_OUTSIDE_DATA("other readings of SOMS on the bunny");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  const Mesh& bunny = *models.objects.front().mesh;
  EXPECT_EQ(pair_numbers(bunny, 15), (Numbers{904, 1847, 10}));
  EXPECT_EQ(hybrid_numbers(bunny, 15), (Numbers{899, 1841, 6}));
  const Result result = readings({.models = models});
  const std::string why = cell(table_of(result, "readings_reasons"), 3, "why");
  EXPECT_NE(why.find("same midpoint on bunny, venus, teapot_1177, teapot, as"), std::string::npos)
      << why;
}

TEST(Readings, MiddlePairPartsWhatSharesItsLeastMidpoint) {
  // Three of four midpoints agree on x: the plane goes to the fourth.
  std::array<Primitive, 4> primitives{};
  for (TriangleId id = 0; id < 4; ++id) {
    primitives.at(id).id = id;
  }
  primitives[3].midpoint = {2, 0, 0};
  const Split split = middle_pair({primitives, {}, {}, 1}, 0);
  EXPECT_EQ(split.value, 2);
  primitives[3].midpoint = {0, 0, 0};
  EXPECT_EQ(middle_pair({primitives, {}, {}, 1}, 0).value, 0);  // nothing lies below
}

TEST(Readings, HybridDividesWhereSpatialMedianStops) {
  for (const ToySet& set : flat_toy_sets()) {
    if (set.name == "one_large" || set.name == "each_larger") {
      EXPECT_FALSE(split_toy(set.mesh, Rule::spatial_median).divides());
      EXPECT_EQ(counts_by(set.mesh, spatial_then_soms, AxisFrom::outer, 15).undividable, 0U);
    }
  }
}

TEST(Readings, EachIsTakenOpenSpokenAgainstOrExcludedByWords) {
  const Models models = find_models({}, {.scenes = true});
  const Result result = readings({.models = models});
  const Table& reasons = table_of(result, "readings_reasons");
  std::map<std::string, std::string> stands;
  for (std::size_t i = 0; i < reasons.rows.size(); ++i) {
    stands[cell(reasons, i, "reading")] = cell(reasons, i, "stands");
    EXPECT_FALSE(cell(reasons, i, "speaks_for").empty());
    EXPECT_FALSE(cell(reasons, i, "why").empty());
  }
  EXPECT_EQ(stands, (std::map<std::string, std::string>{{"soms", "taken"},
                                                        {"middle_pair", "against"},
                                                        {"spatial_then_soms", "excluded by words"},
                                                        {"aabb_midpoint", "against"},
                                                        {"centroid", "excluded by words"},
                                                        {"tree_per_object", "open"}}));
  const Table& counts = table_of(result, "readings");
  EXPECT_EQ(counts.rows.size(), 5 * models.scenes.size() + 1);
  std::map<std::string, std::string> one;
  for (std::size_t i = 0; i < counts.rows.size(); ++i) {
    one[cell(counts, i, "reading") + " " + cell(counts, i, "model")] = cell(counts, i, "one");
  }
  EXPECT_EQ(one["aabb_midpoint u_boxes"], "0");
  EXPECT_EQ(one["aabb_midpoint u_plain"], "0");
  EXPECT_EQ(one["aabb_midpoint u_mixed"], "278");
  EXPECT_EQ(one["centroid u_plain"], "1966");
  EXPECT_EQ(one["tree_per_object u_mixed"], "4019");
  EXPECT_EQ(one["soms u_plain"], "1893");
}

TEST(Readings, WhatSpeaksAgainstOneNamesTheModels) {
  const Models models = find_models({}, {.scenes = true});
  const Result result = readings({.models = models});
  const Table& reasons = table_of(result, "readings_reasons");
  const auto why = [&](std::size_t row) { return cell(reasons, row, "why"); };
  EXPECT_NE(
      why(1).find("Here it is 12 on u_mixed, 12 on u_boxes, 12 on u_plain; with SOMS as taken "
                  "10 on u_mixed, 10 on u_boxes, 9 on u_plain, so the level excludes neither."),
      std::string::npos)
      << why(1);
  EXPECT_NE(why(3).find("On u_boxes, u_plain it has no leaf"), std::string::npos) << why(3);
  EXPECT_NE(why(3).find("same midpoint on u_mixed, as"), std::string::npos) << why(3);
}

TEST(Readings, AMeshComesApartIntoItsInnermostParts) {
  Mesh mesh = grid_toy_set().mesh;
  mesh.parts = {{"all", Part::kNoParent, 0, 10}, {"inner", 0, 2, 3}, {"none", 0, 5, 0}};
  const std::vector<Mesh> objects = object_meshes(mesh);
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[0].triangles.size(), 7U);
  EXPECT_EQ(objects[1].triangles.size(), 3U);
  EXPECT_EQ(objects[2].triangles.size(), mesh.triangles.size() - 10);
  EXPECT_EQ(objects[1].triangle(0).a, mesh.triangle(2).a);
  EXPECT_EQ(objects[0].triangle(2).c, mesh.triangle(5).c);
  EXPECT_TRUE(object_meshes(Mesh{}).empty());
}

TEST(Readings, BalanceOfASmallTreeIsWhatCountingByHandGives) {
  const BuildOptions halves = thesis_options(Rule::object_median);
  const Mesh mesh = grid_toy_set().mesh;  // 16 triangles
  const BalanceMeasures even = balance_of(build(mesh, halves), halves);
  EXPECT_EQ(even.balanced_level, 5);
  EXPECT_EQ(even.small_leaves, 16);
  EXPECT_EQ(even.unevenness, 0);
  // Spatial median cannot divide the root: all triangles on one side.
  const BuildOptions stops = thesis_options(Rule::spatial_median);
  const Mesh large = flat_toy_sets().at(1).mesh;
  const Tree stuck = build(large, stops);
  const BalanceMeasures one_leaf = balance_of(stuck, stops);
  EXPECT_EQ(one_leaf.balanced_level, 1);
  EXPECT_EQ(one_leaf.small_leaves, 1);
  EXPECT_EQ(one_leaf.unevenness, 1);
  EXPECT_EQ(stuck_nodes(stuck, large, stops).partable, 1U);
  // All midpoints are one point: stuck, but no plane could do better.
  const Mesh point = flat_toy_sets().at(3).mesh;
  const StuckNodes none = stuck_nodes(build(point, stops), point, stops);
  EXPECT_EQ(none.all, 1U);
  EXPECT_EQ(none.partable, 0U);
  EXPECT_EQ(none.largest, 3U);
  EXPECT_EQ(balance_of(Tree{}, halves).small_leaves, 0);
}

}  // namespace
}  // namespace soms::reproduce
