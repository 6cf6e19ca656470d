#include "apps/soms/overlap_rows.h"

#include "apps/soms/overlap_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace soms::command {
namespace {

/// Triangles that all lie in the same place, each a part of its own.
Mesh pile(std::uint32_t triangles) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(triangles, {0, 1, 2});
  for (std::uint32_t k = 0; k < triangles; ++k) {
    mesh.parts.push_back({.name = "p", .first = k, .count = 1});
  }
  return mesh;
}

TEST(OverlapRows, SampleIsFairBoundedAndSpreadOverPoses) {
  const Mesh a = pile(10);
  const Mesh b = pile(1);
  OverlapRows rows(a, b, 100);
  std::vector<TrianglePair> pairs;
  for (TriangleId k = 0; k < 10; ++k) {
    pairs.emplace_back(k, 0);
  }
  constexpr std::uint64_t kPoses = 1000;
  for (std::uint64_t pose = 0; pose < kPoses; ++pose) {
    rows.add(pose, {Pose(), Pose()}, pairs);
    EXPECT_LE(rows.held(), 100U);
    EXPECT_LE(rows.placed().size(), 200U);
  }
  ASSERT_EQ(rows.rows().size(), 10U);
  for (const OverlapRows::Row& row : rows.rows()) {
    EXPECT_EQ(row.count, kPoses);
    EXPECT_EQ(row.poses, kPoses);
    EXPECT_EQ(row.end, kPoses - 1);
    ASSERT_GE(row.samples.size(), 3U);
    EXPECT_EQ(row.samples.front().pose, 0U);
    EXPECT_GT(row.samples.back().pose, kPoses / 2);
    for (const OverlapRows::Sample& sample : row.samples) {
      EXPECT_TRUE(rows.placed().contains(sample.pose));
    }
  }
}

TEST(OverlapRows, OneOfManyTrianglesLeavesRoomForOneOfFew) {
  const Mesh a = pile(2);
  const Mesh b = pile(500);
  OverlapRows rows(a, b, 40);
  std::vector<TrianglePair> pairs;
  for (TriangleId k = 0; k < 500; ++k) {
    pairs.emplace_back(0, k);
  }
  pairs.emplace_back(1, 499);
  rows.add(0, {Pose(), Pose()}, pairs);
  ASSERT_EQ(rows.rows().size(), 501U) << "each is listed, with a sample or without";
  EXPECT_EQ(rows.held(), 40U);
  EXPECT_EQ(rows.rows().back().count, 1U);
}

TEST(PartPairs, CountPairsOfTrianglesAndHoldTheirPoints) {
  const Mesh a = pile(3);
  Mesh b = pile(2);
  b.vertices = {{0.25, 0.25, -1}, {0.25, 0.25, 1}, {0.25, 3, 1}};
  const PartsOf parts_a(a);
  const PartsOf parts_b(b);
  const Pose still;
  const std::vector<TrianglePair> pairs{{0, 0}, {0, 1}, {2, 1}};
  const std::vector<PartPair> found = part_pairs({a, parts_a, still}, {b, parts_b, still}, pairs);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[2].a, 2U);
  EXPECT_EQ(found[2].b, 1U);
  EXPECT_EQ(found[2].count, 1U);
  EXPECT_EQ(found[2].first, (TrianglePair{2, 1}));
  // They cross from (0.25, 0.25, 0) to (0.25, 0.75, 0).
  EXPECT_TRUE(found[2].box.contains({{0.25, 0.25, 0}, {0.25, 0.75, 0}}));
  EXPECT_NEAR(found[2].box.upper.y, 0.75, 1e-9);
}

}  // namespace
}  // namespace soms::command
