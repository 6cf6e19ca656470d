// The truth set of two closed bodies, by every layout, alone and in batches, on one thread and two.
#include "soms/base/error.h"
#include "soms/query/reference/solid.h"
#include "soms/query/solid.h"

#include "tests/support/needs_instruction_set.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/question_truth.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

constexpr std::array<Layout, 2> kLayouts{Layout::wide, Layout::compact};

Relation exchanged(Relation relation) {
  return relation == Relation::a_in_b   ? Relation::b_in_a
         : relation == Relation::b_in_a ? Relation::a_in_b
                                        : relation;
}

void expect_relation(const Solid& found, const test::SolidRow& row) {
  ASSERT_EQ(static_cast<int>(found.relation), static_cast<int>(row.relation));
  ASSERT_EQ(found.surfaces_meet, row.count > 0);
  ASSERT_EQ(found.why, Undecided::none);
  ASSERT_EQ(found.coverage, Coverage::complete);
}

/// Both orders, alone.
void run(const test::SolidRow& row, const Shape& a, const Shape& b) {
  const ClosedBody body_a(Body(a, row.pose_a));
  const ClosedBody body_b(Body(b, row.pose_b));
  const Solid alone = solid(body_a, body_b);
  ASSERT_NO_FATAL_FAILURE(expect_relation(alone, row));
  ASSERT_EQ(solid(body_a, body_b, {.threads = 1}), alone);
  test::SolidRow turned = row;
  turned.relation = exchanged(row.relation);
  ASSERT_NO_FATAL_FAILURE(expect_relation(solid(body_b, body_a), turned));
}

/// Rows of one pair of meshes that differ in the pose of a only: a batch.
void run_batches(const std::vector<test::SolidRow>& rows, Layout layout) {
  for (const test::SolidRow& row : rows) {
    SCOPED_TRACE(row.mesh_a + ", " + row.mesh_b + ", " + row.kind);
    const Shape a(*test::question_mesh(row.mesh_a), {.layout = layout});
    const Shape b(*test::question_mesh(row.mesh_b), {.layout = layout});
    ASSERT_NO_FATAL_FAILURE(run(row, a, b));
    const std::vector<Pose> poses{row.pose_a, Pose{}, row.pose_a};
    const Body fixed(b, row.pose_b);
    const SolidBatch batch = solid(a, poses, fixed);
    ASSERT_EQ(batch.size(), 3U);
    ASSERT_EQ(batch.at(0), solid(Body(a, row.pose_a), fixed));
    ASSERT_EQ(batch.at(0), batch.at(2));
    ASSERT_EQ(batch.at(1), solid(Body(a), fixed));
    ASSERT_EQ(solid(a, poses, fixed, {.threads = 2}), batch);
  }
}

/// Rows of bodies whose surfaces do not meet, from the truth set of overlaps.
std::vector<test::SolidRow> rows_apart() {
  std::vector<test::SolidRow> rows;
  for (const test::TruthCase& c : test::truth_cases()) {
    const auto relation = test::relation_named(c.solid);
    if (relation && test::question_mesh(c.mesh_a) != nullptr &&
        test::question_mesh(c.mesh_b) != nullptr) {
      rows.push_back({c.mesh_a, c.mesh_b, c.kind, c.pose_a, c.pose_b, c.count, *relation});
    }
  }
  return rows;
}

/// Every 16th row under a sanitizer, where all take minutes.
std::vector<test::SolidRow> some_of(const std::vector<test::SolidRow>& rows) {
  std::vector<test::SolidRow> some;
  for (std::size_t i = 0; i < rows.size(); i += test::kSlowBuild ? 16 : 1) {
    some.push_back(rows[i]);
  }
  return some;
}

using SolidTruth = test::NeedsInstructionSet;

TEST_F(SolidTruth, HoldsForTheRowsHere) {
  const auto rows = test::read_solid_rows(test::data("questions/solid.csv"));
  ASSERT_EQ(rows.size(), 626U);
  for (const Layout layout : kLayouts) {
    ASSERT_NO_FATAL_FAILURE(run_batches(some_of(rows), layout));
  }
}

/// The row of each kind and relation that has the fewest triangles.
std::vector<test::SolidRow> small_rows_of_all_kinds() {
  const auto size = [](const test::SolidRow& row) {
    return test::question_mesh(row.mesh_a)->triangles.size() +
           test::question_mesh(row.mesh_b)->triangles.size();
  };
  std::map<std::pair<std::string, Relation>, test::SolidRow> least;
  for (const test::SolidRow& row : test::read_solid_rows(test::data("questions/solid.csv"))) {
    const auto [kept, is_new] = least.try_emplace({row.kind, row.relation}, row);
    if (!is_new && size(row) < size(kept->second)) {
      kept->second = row;
    }
  }
  std::vector<test::SolidRow> rows;
  for (const auto& [key, row] : least) {
    rows.push_back(row);
  }
  return rows;
}

// What is run with each instruction set: every kind of contact, in one layout or the other.
TEST_F(SolidTruth, HoldsForSmallRowsOfAllKinds) {
  const auto rows = small_rows_of_all_kinds();
  ASSERT_EQ(rows.size(), 35U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_NO_FATAL_FAILURE(run_batches({rows[i]}, kLayouts[i % kLayouts.size()]));
  }
}

TEST_F(SolidTruth, IsWhatBruteForceFinds) {
  for (const test::SolidRow& row :
       some_of(test::read_solid_rows(test::data("questions/solid.csv")))) {
    const Mesh& a = *test::question_mesh(row.mesh_a);
    const Mesh& b = *test::question_mesh(row.mesh_b);
    if (a.triangles.size() + b.triangles.size() <= 500) {
      SCOPED_TRACE(row.mesh_a + ", " + row.mesh_b + ", " + row.kind);
      ASSERT_NO_FATAL_FAILURE(expect_relation(
          reference::solid_by_brute_force(Body(a, row.pose_a), Body(b, row.pose_b)), row));
    }
  }
}

TEST_F(SolidTruth, HoldsForBodiesWhoseSurfacesAreApart) {
  const auto rows = rows_apart();
  ASSERT_GE(rows.size(), 1000U);
  for (const Layout layout : kLayouts) {
    for (const test::SolidRow& row : some_of(rows)) {
      SCOPED_TRACE(row.mesh_a + ", " + row.mesh_b + ", " + row.kind);
      const Shape a(*test::question_mesh(row.mesh_a), {.layout = layout});
      const Shape b(*test::question_mesh(row.mesh_b), {.layout = layout});
      ASSERT_NO_FATAL_FAILURE(run(row, a, b));
    }
  }
}

}  // namespace
}  // namespace soms
