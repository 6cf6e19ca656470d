#include "thesis/trees/toy_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace soms::reproduce {
namespace {

const Mesh& flat(const std::string& name) {
  static const std::vector<ToySet> sets = flat_toy_sets();
  for (const ToySet& set : sets) {
    if (set.name == name) {
      return set.mesh;
    }
  }
  throw std::runtime_error(name);
}

std::vector<bool> left_of(const std::string& name, Rule rule) {
  return split_toy(flat(name), rule).left;
}

using Sides = std::vector<bool>;

TEST(ToySets, HaveTheMidpointsTheyAreMadeFor) {
  const ToySplit alike = split_toy(flat("alike"), Rule::soms);
  EXPECT_EQ(alike.midpoints.front(), (Vec3{1, 2, 0}));
  EXPECT_EQ(alike.inner, (Box{{1, 1, 0}, {18, 5, 0}}));
  const ToySplit large = split_toy(flat("one_large"), Rule::soms);
  EXPECT_EQ(large.midpoints.front(), (Vec3{8, 3.25, 0}));
  const ToySplit one = split_toy(flat("one_midpoint"), Rule::soms);
  EXPECT_EQ(one.inner.lower, one.inner.upper);
}

/// Area of the largest triangle over that of the smallest.
double spread_of(const Mesh& mesh) {
  double least = 1e300;
  double most = 0;
  for (TriangleId id = 0; id < mesh.triangles.size(); ++id) {
    const Triangle t = mesh.triangle(id);
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    least = std::min(least, dot(normal, normal));
    most = std::max(most, dot(normal, normal));
  }
  return std::sqrt(most / least);
}

TEST(ToySets, AreMarkedUnlikeWhereTheLargestTriangleIsAtLeastFourTimesTheSmallest) {
  std::vector<ToySet> sets = flat_toy_sets();
  sets.push_back(grid_toy_set());
  sets.push_back(solid_toy_set());
  for (const ToySet& set : sets) {
    EXPECT_EQ(spread_of(set.mesh) >= 4, set.unlike) << set.name;
  }
}

TEST(ToySets, TheGridHasItsMidpointsInTwoRowsOfEight) {
  const ToySplit split = split_toy(grid_toy_set().mesh, Rule::soms);
  EXPECT_EQ(split.midpoints.size(), 16U);
  EXPECT_EQ(split.midpoints.front(), (Vec3{15, 1, 0}));
  EXPECT_EQ(split.inner, (Box{{1, 1, 0}, {15, 4, 0}}));
  EXPECT_EQ(split.left_count, 8U);
}

TEST(ToySets, ObjectMedianHalvesByCountEverywhere) {
  EXPECT_EQ(split_toy(flat("alike"), Rule::object_median).left_count, 4U);
  EXPECT_EQ(left_of("one_large", Rule::object_median), (Sides{false, true, true, false}));
  EXPECT_EQ(left_of("one_midpoint", Rule::object_median), (Sides{true, false, false}));
  EXPECT_EQ(left_of("same_on_long_axis", Rule::object_median), (Sides{true, false, false}));
}

TEST(ToySets, ObjectMeanPutsItsPlaneAtTheMeanOfTheMidpoints) {
  const ToySplit alike = split_toy(flat("alike"), Rule::object_mean);
  EXPECT_EQ(alike.axis, 0U);
  EXPECT_EQ(alike.plane, 6.5);  // 52 / 8
  EXPECT_EQ(alike.left_count, 5U);
  const ToySplit large = split_toy(flat("one_large"), Rule::object_mean);
  EXPECT_EQ(large.plane, 4.25);  // 17 / 4
  EXPECT_EQ(large.left, (Sides{false, true, true, false}));
}

TEST(ToySets, ObjectMeanFailsWhereMidpointsAgreeOnTheLongAxis) {
  EXPECT_FALSE(split_toy(flat("one_midpoint"), Rule::object_mean).divides());
  const ToySplit split = split_toy(flat("same_on_long_axis"), Rule::object_mean);
  EXPECT_EQ(split.axis, 0U);
  EXPECT_EQ(split.plane, 10);
  EXPECT_FALSE(split.divides());
}

TEST(ToySets, SpatialMedianHalvesTheOuterBoxAndFailsBesideOneLargeTriangle) {
  const ToySplit alike = split_toy(flat("alike"), Rule::spatial_median);
  EXPECT_DOUBLE_EQ(alike.plane, 9.5);  // corners reach from 0.2 to 18.8
  EXPECT_EQ(alike.left_count, 6U);
  const ToySplit large = split_toy(flat("one_large"), Rule::spatial_median);
  EXPECT_EQ(large.plane, 12);
  EXPECT_EQ(large.left_count, 4U);
  EXPECT_FALSE(large.divides());
  EXPECT_EQ(split_toy(flat("each_larger"), Rule::spatial_median).plane, 8);
  EXPECT_FALSE(split_toy(flat("each_larger"), Rule::spatial_median).divides());
  EXPECT_FALSE(split_toy(flat("one_midpoint"), Rule::spatial_median).divides());
  EXPECT_FALSE(split_toy(flat("same_on_long_axis"), Rule::spatial_median).divides());
}

TEST(ToySets, SomsHalvesTheInnerBoxAndFailsOnlyWhereAllMidpointsAreEqual) {
  const ToySplit alike = split_toy(flat("alike"), Rule::soms);
  EXPECT_EQ(alike.plane, 9.5);  // (1 + 18) / 2
  EXPECT_EQ(alike.left_count, 6U);
  const ToySplit large = split_toy(flat("one_large"), Rule::soms);
  EXPECT_EQ(large.plane, 4.5);  // (1 + 8) / 2
  EXPECT_EQ(large.left, (Sides{false, true, true, false}));
  const ToySplit across = split_toy(flat("same_on_long_axis"), Rule::soms);
  EXPECT_EQ(across.axis, 1U);
  EXPECT_EQ(across.plane, 3);
  EXPECT_EQ(across.left, (Sides{true, false, false}));
  EXPECT_FALSE(split_toy(flat("one_midpoint"), Rule::soms).divides());
}

TEST(ToySets, OnlySpatialMedianFailsOnHousesBesideALargeTriangle) {
  const Mesh houses = solid_toy_set().mesh;
  const ToySplit spatial = split_toy(houses, Rule::spatial_median);
  EXPECT_EQ(spatial.axis, 0U);
  EXPECT_EQ(spatial.plane, 12);
  EXPECT_EQ(spatial.left_count, houses.triangles.size());
  const ToySplit soms = split_toy(houses, Rule::soms);
  EXPECT_EQ(soms.axis, 0U);
  EXPECT_EQ(soms.plane, 0.5 * (soms.inner.lower.x + soms.inner.upper.x));
  for (const Rule rule : {Rule::object_median, Rule::object_mean, Rule::soms}) {
    EXPECT_TRUE(split_toy(houses, rule).divides());
  }
}

}  // namespace
}  // namespace soms::reproduce
