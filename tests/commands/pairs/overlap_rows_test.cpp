#include "apps/soms/pairs/overlap_rows.h"

#include "soms/base/error.h"
#include "soms/geometry/contact_box.h"

#include "apps/soms/pairs/overlap_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <utility>
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

void add(OverlapRows& rows, std::uint64_t pose, const std::vector<TrianglePair>& pairs) {
  const OverlapRows::Poses still;
  rows.add(pose, still, pairs, rows.parts(still, pairs, {}));
}

TEST(OverlapRows, SampleIsFairBoundedAndSpreadOverPoses) {
  const Mesh a = pile(10);
  const Mesh b = pile(1);
  OverlapRows rows(a, b, 100);
  std::vector<TrianglePair> pairs;
  for (TriangleId k = 0; k < 10; ++k) {
    pairs.push_back({k, 0});
  }
  constexpr std::uint64_t kPoses = 1000;
  for (std::uint64_t pose = 0; pose < kPoses; ++pose) {
    add(rows, pose, pairs);
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
    pairs.push_back({0, k});
  }
  pairs.push_back({1, 499});
  add(rows, 0, pairs);
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

TEST(PartPairs, BoxHoldsSharedPointsAtMapCoordinates) {
  for (int k = 0; k < 50; ++k) {
    const double north = 5'400'000 + k;
    const Triangle floor{{-10, north - 10, 0}, {20, north - 10, 0}, {0, north + 40, 0}};
    const Triangle wall{{1, north, -1}, {1, north + 10, 2}, {1, north + 5, 2}};
    Box box;
    grow_by_contact(box, 0, floor, wall);
    // They cross a third of the way along two edges of the wall.
    EXPECT_LE(static_cast<long double>(box.lower.y), north + 5.0L / 3) << k;
    EXPECT_GE(static_cast<long double>(box.upper.y), north + 10.0L / 3) << k;
    EXPECT_NEAR(box.lower.y, north + 5.0 / 3, 2e-8);
    EXPECT_NEAR(box.upper.y, north + 10.0 / 3, 2e-8);
  }
}

TEST(PartPairs, EndWhenAStopIsRequested) {
  const Mesh a = pile(1);
  const PartsOf parts(a);
  const Pose still;
  const std::vector<TrianglePair> pairs(10'000, {0, 0});
  std::stop_source stop;
  int begun = 0;
  const auto earlier = [&](std::uint32_t, std::uint32_t) {
    ++begun;
    stop.request_stop();  // amid the work
    return std::pair(std::uint64_t{0}, Box());
  };
  try {
    static_cast<void>(part_pairs({a, parts, still}, {a, parts, still}, pairs,
                                 {.stop = stop.get_token()}, earlier));
    ADD_FAILURE() << "goes on to the end";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
  EXPECT_EQ(begun, 1);
}

TEST(OverlapRows, BoxIsTheSameFromPairsOfPartsThatAreKnown) {
  const Mesh a = pile(2);
  Mesh b = pile(1);
  b.vertices = {{0.25, 0.25, -1}, {0.25, 0.25, 1}, {0.25, 3, 1}};
  const std::vector<TrianglePair> pairs{{0, 0}, {1, 0}};
  const OverlapRows::Poses still;
  OverlapRows alone(a, b, 10);
  OverlapRows shared(a, b, 10);
  for (std::uint64_t pose = 0; pose < 3; ++pose) {
    add(alone, pose, pairs);
    shared.add(pose, still, pairs,
               part_pairs({a, PartsOf(a), still.first}, {b, PartsOf(b), still.second}, pairs));
  }
  ASSERT_EQ(shared.rows().size(), 2U);
  for (std::size_t r = 0; r < 2; ++r) {
    EXPECT_EQ(shared.rows()[r].count, 3U);
    EXPECT_EQ(alone.rows()[r].count, 3U);
    EXPECT_EQ(shared.rows()[r].poses, 3U);
    EXPECT_EQ(shared.rows()[r].box, alone.rows()[r].box);
  }
}

}  // namespace
}  // namespace soms::command
