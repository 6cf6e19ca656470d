// Sorting what is near ends with the time, and says what it knows.
#include "soms/query/detail/near/point_goal.h"

#include "soms/query/body.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <vector>

namespace soms {
namespace {

// Corners with whole coordinates of which the squares add up to 1,105, and one that is nearer.
Body spikes() {
  Mesh mesh;
  for (const Vec3& tip : {Vec3{33, 4, 0},
                          {32, 9, 0},
                          {31, 12, 0},
                          {24, 23, 0},
                          {4, 33, 0},
                          {9, 32, 0},
                          {12, 31, 0},
                          {1, 2, 3},
                          {23, 24, 0}}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {tip, 2 * tip, 2 * tip + Vec3{0, 0, 1}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return Body(std::move(mesh));
}

constexpr TriangleId kNearest = 7;

std::vector<TriangleId> sorted_ids(detail::SeveralGoal& goal, detail::Limit& limit, Cost& cost) {
  std::vector<TriangleId> ids;
  for (const std::size_t i : goal.sorted(limit, cost)) {
    ids.push_back(goal.found()[i].id);
  }
  return ids;
}

class SeveralGoalTest : public testing::Test {
 protected:
  SeveralGoalTest() {
    for (TriangleId id = 9; id-- > 0;) {
      goal_.offer(id, cost_);
    }
  }

  Body body_ = spikes();
  detail::PointFrame frame_{body_};
  detail::SeveralGoal goal_{frame_, {}, 100, 1e3};
  Cost cost_;
  Limits limits_;
};

TEST_F(SeveralGoalTest, SortsExactTiesByNumber) {
  detail::Limit endless(limits_);
  const std::uint64_t before = cost_.exact_tests;
  EXPECT_EQ(sorted_ids(goal_, endless, cost_),
            (std::vector<TriangleId>{kNearest, 0, 1, 2, 3, 4, 5, 6, 8}));
  EXPECT_FALSE(endless.late());
  EXPECT_GT(cost_.exact_tests, before);
}

TEST_F(SeveralGoalTest, SortsByBoundsWhenTimeIsUp) {
  limits_.deadline = std::chrono::steady_clock::time_point();
  detail::Limit past(limits_);
  const std::uint64_t before = cost_.exact_tests;
  const std::vector<TriangleId> ids = sorted_ids(goal_, past, cost_);
  EXPECT_TRUE(past.late());
  EXPECT_LE(cost_.exact_tests, before + 2);  // those of one comparison
  ASSERT_EQ(ids.size(), 9U);
  EXPECT_EQ(ids.front(), kNearest);
  for (std::size_t i = 1; i < ids.size(); ++i) {
    EXPECT_LE(goal_.found()[8 - ids[i - 1]].pair.bounds().lower,
              goal_.found()[8 - ids[i]].pair.bounds().lower);
  }
}

}  // namespace
}  // namespace soms
