// The truth set of points in bodies, by every rule, layout, number of threads and instruction set,
// alone and in batches.
#include "soms/base/error.h"
#include "soms/query/contains.h"
#include "soms/query/reference/contains.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/needs_instruction_set.h"
#include "tests/support/support.h"
#include "tests/support/truth/question_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

/// The rows of one mesh.
struct Points {
  std::vector<Vec3> points;
  std::vector<Side> sides;
  std::vector<std::string> kinds;
};

std::map<std::string, Points> by_mesh(const std::vector<test::InsideRow>& rows) {
  std::map<std::string, Points> meshes;
  for (const test::InsideRow& row : rows) {
    Points& mesh = meshes[row.mesh];
    mesh.points.push_back(row.point);
    mesh.sides.push_back(row.side);
    mesh.kinds.push_back(row.kind);
  }
  return meshes;
}

void expect_sides(const std::vector<Side>& found, const Points& expected) {
  ASSERT_EQ(found.size(), expected.sides.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i], expected.sides[i])
        << "point " << i << ", " << expected.kinds[i] << ": " << expected.points[i].x << ", "
        << expected.points[i].y << ", " << expected.points[i].z;
  }
}

/// One body, in batches and one by one, which must cost the same.
void run(const ClosedBody& body, const Points& points) {
  const ContainsBatch batch = contains(body, points.points);
  ASSERT_NO_FATAL_FAILURE(expect_sides(batch.side, points));
  ASSERT_EQ(batch.coverage, std::vector<Coverage>(batch.size(), Coverage::complete));
  ASSERT_EQ(contains(body, points.points, {.threads = 2}), batch);
  Cost cost;
  std::vector<Side> sides;
  for (const Vec3& point : points.points) {
    const Contains answer = contains(body, point);
    ASSERT_EQ(answer.coverage, Coverage::complete);
    sides.push_back(answer.side);
    cost += answer.cost;
  }
  ASSERT_NO_FATAL_FAILURE(expect_sides(sides, points));
  ASSERT_EQ(cost, batch.cost);
}

void run(const std::vector<test::InsideRow>& rows) {
  for (const auto& [name, points] : by_mesh(rows)) {
    const Mesh& mesh = *test::question_mesh(name);
    for (const RuleEntry& rule : rules()) {
      for (const Layout layout : {Layout::wide, Layout::compact}) {
        SCOPED_TRACE(name + ", " + std::string(rule.name) +
                     (layout == Layout::wide ? "" : ", compact"));
        const ShapeOptions options{.build = {.rule = rule.rule}, .layout = layout};
        ASSERT_NO_FATAL_FAILURE(run(ClosedBody(Body(Shape(mesh, options))), points));
      }
    }
  }
}

using ContainsTruth = test::NeedsInstructionSet;

TEST_F(ContainsTruth, HoldsForThePointsHere) {
  const auto rows = test::read_inside_rows(test::data("questions/inside.csv"));
  ASSERT_EQ(rows.size(), 1085U);
  run(rows);
}

TEST_F(ContainsTruth, OfThePointsHereIsWhatBruteForceFinds) {
  for (const auto& [name, points] :
       by_mesh(test::read_inside_rows(test::data("questions/inside.csv")))) {
    SCOPED_TRACE(name);
    const Body body(*test::question_mesh(name));
    ASSERT_NO_FATAL_FAILURE(
        expect_sides(reference::contains_by_brute_force(body, points.points), points));
  }
}

TEST_F(ContainsTruth, HoldsForAllPoints) {
  const auto file = test::outside_question("inside.csv");
  if (!file) {
    GTEST_SKIP() << "SOMS_DATA has no questions/inside.csv: skipped 20,000 points";
  }
  const auto rows = test::read_inside_rows(*file);
  ASSERT_EQ(rows.size(), 20'000U);
  run(rows);
}

}  // namespace
}  // namespace soms
