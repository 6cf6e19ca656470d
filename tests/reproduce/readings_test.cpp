// Other readings of SOMS: what they count, by an independent implementation, and how they stand.
#include "soms/tree/build.h"
#include "soms/tree/statistics.h"

#include "tests/reproduce/trips.h"
#include "tests/support/support.h"
#include "thesis/experiments/experiments.h"
#include "thesis/trees/alternative_rules.h"
#include "thesis/trees/balance_measures.h"
#include "thesis/trees/stuck_nodes.h"
#include "thesis/trees/toy_sets.h"
#include "thesis/trips/object_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <span>
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
  const std::string why = cell(table_of(result, "readings_reasons"), 4, "why");
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

/// Compares the rows of these models with what an independent program counted; returns how many.
std::size_t compare_corner_pairs(std::span<const Model> models) {
  std::size_t compared = 0;
  for (const auto& row : soms::test::read_csv(soms::test::data("thesis/corner_pair.csv"))) {
    for (const Model& model : models) {
      if (model.name != row.front()) {
        continue;
      }
      const int level = std::stoi(row.at(2));
      const TreeStatistics s =
          statistics(corner_pair_tree(*model.mesh, level), thesis_options(Rule::soms, level));
      const std::array counts{s.nodes,          s.leaves,         s.one,          s.lt5,
                              s.undividable,    s.capped,         s.empty,        s.depth,
                              s.min_leaf_depth, s.max_leaf_depth, s.largest_leaf, s.balanced_level};
      for (std::size_t k = 0; k < counts.size(); ++k) {
        EXPECT_EQ(std::to_string(counts.at(k)), row.at(3 + k)) << model.name << " level " << level;
      }
      ++compared;
    }
  }
  return compared;
}

TEST(Readings, CornerPairsOnTheScenesAreGolden) {
  EXPECT_EQ(compare_corner_pairs(find_models({}, {.scenes = true}).scenes), 48U);
}

TEST(Readings, CornerPairsOnTheObjectsAreGolden) {
  SOMS_NEEDS_OUTSIDE_DATA("64 rows of corner_pair.csv");
  const Models models = find_models(*soms::test::outside_data(""), {.objects = true});
  EXPECT_EQ(compare_corner_pairs(models.objects), 64U);
}

/// Triangles along x, of which only that coordinate differs.
Mesh along_x(std::span<const std::array<double, 3>> corners) {
  Mesh mesh;
  for (const std::array<double, 3>& x : corners) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{x[0], 0, 0}, {x[1], 1, 0}, {x[2], 0, 1}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

TEST(Readings, CornerPairTakesTheFirstOfEqualCorners) {
  // Midpoints 7.5, 8, 11.5 and 5; the first and the last share the least corner.
  const std::array<std::array<double, 3>, 4> corners{
      {{0, 10, 10}, {8, 8, 8}, {11, 11, 12}, {0, 0, 10}}};
  const Mesh mesh = along_x(corners);
  const std::array<TriangleId, 4> forward{0, 1, 2, 3};
  EXPECT_EQ(corner_pair(mesh, forward).axis, 0U);
  EXPECT_EQ(corner_pair(mesh, forward).value, 9.5);
  const std::array<TriangleId, 4> last_first{3, 0, 1, 2};
  EXPECT_EQ(corner_pair(mesh, last_first).value, 8.25);
}

TEST(Readings, CornerPairIsStuckWhereOneTriangleHoldsBothCorners) {
  const std::array<std::array<double, 3>, 3> corners{{{0, 20, 2}, {8, 8, 8}, {9, 9, 9}}};
  const Mesh mesh = along_x(corners);  // midpoints 6, 8 and 9
  const Tree tree = corner_pair_tree(mesh, 15);
  ASSERT_EQ(tree.nodes.size(), 1U);
  EXPECT_TRUE(tree.nodes.front().undividable);
  const BuildOptions options = thesis_options(Rule::soms, 15);
  EXPECT_EQ(statistics(build(mesh, options), options).one, 3U);
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
                                                        {"corner_pair", "against"},
                                                        {"spatial_then_soms", "excluded by words"},
                                                        {"aabb_midpoint", "against"},
                                                        {"centroid", "excluded by words"},
                                                        {"tree_per_object", "open"}}));
  const Table& counts = table_of(result, "readings");
  EXPECT_EQ(counts.rows.size(), 6 * models.scenes.size() + 1);
  std::map<std::string, std::string> one;
  for (std::size_t i = 0; i < counts.rows.size(); ++i) {
    one[cell(counts, i, "reading") + " " + cell(counts, i, "model")] = cell(counts, i, "one");
  }
  EXPECT_EQ(one["corner_pair u_mixed"], "550");
  EXPECT_EQ(one["corner_pair u_plain"], "1419");
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
  EXPECT_NE(why(2).find("152 on u_mixed (as taken 2)"), std::string::npos) << why(2);
  EXPECT_NE(why(4).find("On u_boxes, u_plain it has no leaf"), std::string::npos) << why(4);
  EXPECT_NE(why(4).find("same midpoint on u_mixed, as"), std::string::npos) << why(4);
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
