// The truth set of nearest points, by every rule, layout, number of threads and instruction set,
// alone and in batches.
#include "soms/base/error.h"
#include "soms/query/closest.h"
#include "soms/query/print.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/needs_instruction_set.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/distance_truth.h"
#include "tests/support/truth/truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

using Rows = std::vector<test::ClosestPointRow>;

Closest expected_of(const test::ClosestPointRow& row) {
  return {.distance = row.distance,
          .triangle = row.triangle,
          .point = row.nearest,
          .feature = row.feature};
}

Closest promised(Closest answer) {
  answer.cost = {};
  return answer;
}

std::vector<Vec3> points_of(const Rows& rows) {
  std::vector<Vec3> points;
  for (const test::ClosestPointRow& row : rows) {
    points.push_back(row.point);
  }
  return points;
}

/// Limits at and beside the distance.
void expect_right_limits(const Body& body, const test::ClosestPointRow& row) {
  const Closest expected = expected_of(row);
  ASSERT_EQ(promised(closest(body, row.point, {.at_most = row.distance.upper})), expected);
  if (row.distance.lower == 0) {
    return;
  }
  const double below = std::nextafter(row.distance.lower, 0);
  const Closest farther = closest(body, row.point, {.at_most = below});
  ASSERT_TRUE(farther.farther);
  ASSERT_FALSE(farther.triangle);
  ASSERT_EQ(farther.distance.lower, below);
}

/// As many triangles at exactly the distance as the set says, by number.
void expect_right_ties(const Body& body, const test::ClosestPointRow& row) {
  const std::array points{row.point};
  const NearTriangles nearest = nearest_triangles(body, points, row.ties);
  ASSERT_EQ(nearest.triangle.size(), row.ties);
  ASSERT_EQ(nearest.triangle.front(), row.triangle);
  for (std::size_t i = 0; i < row.ties; ++i) {
    ASSERT_EQ((Bracket{nearest.lower[i], nearest.upper[i]}), row.distance);
    ASSERT_TRUE(i == 0 || nearest.triangle[i] > nearest.triangle[i - 1]);
  }
  const NearTriangles near = near_triangles(body, points, row.distance.upper);
  ASSERT_GE(near.triangle.size(), row.ties);
  ASSERT_TRUE(std::equal(nearest.triangle.begin(), nearest.triangle.end(), near.triangle.begin()));
  if (row.distance.lower > 0) {
    const double below = std::nextafter(row.distance.lower, 0);
    ASSERT_TRUE(near_triangles(body, points, below).triangle.empty());
  }
}

/// All rows of one mesh by one rule and layout.
void run_mesh(const Rows& rows, const Mesh& mesh, const ShapeOptions& options, bool usual) {
  const Body body(Shape(mesh, options));
  const std::vector<Vec3> points = points_of(rows);
  const ClosestBatch one = closest(body, points);
  const ClosestBatch two = closest(body, points, {}, {.threads = 2});
  ASSERT_EQ(one, two);
  const NearTriangles several = nearest_triangles(body, points, 3);
  ASSERT_EQ(several, nearest_triangles(body, points, 3, {}, {.threads = 2}));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE("row " + std::to_string(i) + " of " + rows[i].mesh + ", " + rows[i].kind);
    const Closest single = closest(body, rows[i].point);
    ASSERT_EQ(promised(single), expected_of(rows[i]));
    ASSERT_EQ(single.distance.upper == 0, rows[i].on);
    ASSERT_EQ(one.at(i), single);
    ASSERT_EQ(several.triangle[several.offsets[i]], rows[i].triangle);
    if (usual) {
      ASSERT_NO_FATAL_FAILURE(expect_right_limits(body, rows[i]));
      ASSERT_NO_FATAL_FAILURE(expect_right_ties(body, rows[i]));
    }
  }
}

void run_points(const Rows& rows) {
  std::map<std::string, Rows> by_mesh;
  for (const test::ClosestPointRow& row : rows) {
    by_mesh[row.mesh].push_back(row);
  }
  for (const auto& [name, some] : by_mesh) {
    for (const RuleEntry& rule : rules()) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        SCOPED_TRACE(std::string(rule.name) + (layout == Layout::wide ? "" : ", compact"));
        const bool usual = rule.rule == BuildOptions().rule;
        ASSERT_NO_FATAL_FAILURE(run_mesh(some, *test::truth_mesh(name),
                                         {.build = {.rule = rule.rule}, .layout = layout}, usual));
      }
    }
  }
}

using ClosestTruth = test::NeedsInstructionSet;

TEST_F(ClosestTruth, HoldsForThePointsHere) {
  const Rows rows = test::read_closest_points(test::data("distance/closest.csv"));
  ASSERT_EQ(rows.size(), 345U);
  run_points(rows);
}

TEST_F(ClosestTruth, HoldsForAllPoints) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto file = test::outside_distance("closest.csv");
  if (!file) {
    GTEST_SKIP() << "SOMS_DATA has no distance/closest.csv: skipped 10,164 points";
  }
  const Rows rows = test::read_closest_points(*file);
  ASSERT_EQ(rows.size(), 10'164U);
  run_points(rows);
}

}  // namespace
}  // namespace soms
