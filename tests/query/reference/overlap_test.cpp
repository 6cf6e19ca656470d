#include "soms/query/reference/overlap.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"
#include "soms/base/random.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

namespace soms {
namespace {

/// `count` triangles of size about `size` in the cube [-1, 1]^3.
Mesh soup(std::uint64_t seed, int count, double size) {
  Rng rng(seed);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 at{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(at + size * Vec3{rng.unit(), rng.unit(), rng.unit()});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

/// The square (0,0)-(1,1) at height `z` as two triangles.
Mesh square(double z) {
  Mesh mesh;
  mesh.vertices = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(ReferenceOverlap, ListsPairsThatShareAPoint) {
  const Overlap same = reference::overlap(square(0), {}, square(0), {});
  EXPECT_TRUE(same.any);
  EXPECT_EQ(same.coverage, Coverage::complete);
  EXPECT_EQ(same.pairs, (std::vector<TrianglePair>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
  const Overlap apart = reference::overlap(square(0), {}, square(0x1p-1000), {});
  EXPECT_FALSE(apart.any);
  EXPECT_TRUE(apart.pairs.empty());
  EXPECT_EQ(apart.coverage, Coverage::complete);
}

TEST(ReferenceOverlap, MovesBothMeshesByTheirPoses) {
  const Pose up = Pose::translation(0.5, 0.25, 1);
  EXPECT_TRUE(reference::overlap(square(1), {}, square(0), up).any);
  EXPECT_TRUE(reference::overlap(square(0), up, square(1), {}).any);
  EXPECT_FALSE(reference::overlap(square(0), {}, square(0), up).any);
  const Overlap touching =
      reference::overlap(square(0), {}, square(0), Pose::translation(1, -0.5, 0));
  EXPECT_EQ(touching.pairs, (std::vector<TrianglePair>{{0, 1}}));
}

TEST(ReferenceOverlap, CountsBoxesTrianglesAndExactTests) {
  const Overlap same = reference::overlap(square(0), {}, square(0), {});
  EXPECT_EQ(same.cost, (Cost{4, 4, 0}));
  const Overlap flat =
      reference::overlap(square(0), {}, square(0), Pose::translation(0.5, 0.25, 0));
  EXPECT_EQ(flat.cost.node_tests, 4U);
  EXPECT_EQ(flat.cost.triangle_tests, flat.cost.exact_tests);
}

TEST(ReferenceOverlap, EmptyMeshOverlapsNothing) {
  EXPECT_FALSE(reference::overlap({}, {}, square(0), {}).any);
  EXPECT_FALSE(reference::overlap(square(0), {}, {}, {}).any);
  EXPECT_EQ(reference::overlap({}, {}, {}, {}).cost, Cost{});
}

TEST(ReferenceOverlap, IsTheSameForAnyNumberOfThreads) {
  const Mesh a = soup(1, 300, 0.3);
  const Mesh b = soup(2, 5000, 0.2);
  const Overlap one = reference::overlap(a, {}, b, {});
  EXPECT_GT(one.pairs.size(), 300U);
  EXPECT_EQ(one.cost.node_tests, 300U * 5000U);
  for (const int threads : {2, 8}) {
    const Overlap many =
        reference::overlap(a, {}, b, {}, {.threads = threads, .stop = {}, .progress = {}});
    EXPECT_EQ(many.pairs, one.pairs);
    EXPECT_EQ(many.cost, one.cost);
  }
}

TEST(ReferenceOverlap, SwapsColumnsWhenTheMeshesAreSwapped) {
  const Mesh a = soup(3, 100, 0.4);
  const Mesh b = soup(4, 130, 0.3);
  const Pose turn = Pose::about_z(0.3, {0.1, 0, 0});
  std::vector<TrianglePair> swapped;
  for (const auto& [j, i] : reference::overlap(b, {}, a, turn).pairs) {
    swapped.push_back({i, j});
  }
  std::sort(swapped.begin(), swapped.end());
  EXPECT_EQ(reference::overlap(a, turn, b, {}).pairs, swapped);
}

ErrorKind kind_thrown(const Mesh& a, const Pose& pose, const Limits& limits = {}) {
  try {
    static_cast<void>(reference::overlap(a, pose, square(0), {}, limits));
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return ErrorKind::usage;
}

TEST(ReferenceOverlap, RefusesBadPosesAndMeshesAtTheDoor) {
  Pose stretched;
  stretched.m[0] = 1.001;
  EXPECT_EQ(kind_thrown(square(0), stretched), ErrorKind::not_rigid);
  EXPECT_EQ(
      kind_thrown(square(0), Pose::translation(0, std::numeric_limits<double>::quiet_NaN(), 0)),
      ErrorKind::not_finite);
  EXPECT_EQ(kind_thrown(square(0), Pose::translation(0, 0, 0x1.8p300)), ErrorKind::out_of_range);
  EXPECT_EQ(kind_thrown(square(0x1p301), {}), ErrorKind::out_of_range);
}

TEST(ReferenceOverlap, StopsOnRequest) {
  std::stop_source source;
  source.request_stop();
  EXPECT_EQ(kind_thrown(square(0), {}, {.threads = 1, .stop = source.get_token(), .progress = {}}),
            ErrorKind::cancelled);
}

std::uint64_t hash_of(const std::vector<TrianglePair>& pairs) {
  Fnv1a hash;
  for (const auto& [i, j] : pairs) {
    hash.add(i);
    hash.add(j);
  }
  return hash.value();
}

void expect_truth(const test::TruthCase& c) {
  SCOPED_TRACE("case " + std::to_string(c.number) + ", " + c.kind + ", " + c.mesh_a + " and " +
               c.mesh_b);
  const Overlap answer = reference::overlap(*test::truth_mesh(c.mesh_a), c.pose_a,
                                            *test::truth_mesh(c.mesh_b), c.pose_b);
  ASSERT_EQ(answer.any, c.overlap);
  ASSERT_EQ(answer.pairs.size(), c.count);
  ASSERT_EQ(hash_of(answer.pairs), c.hash);
  if (c.listed) {
    const auto& lists = test::truth_lists();
    const auto list = lists.find(c.number);
    ASSERT_EQ(answer.pairs, list == lists.end() ? std::vector<TrianglePair>{} : list->second);
  }
}

// Each case was decided by two independent exact methods.
TEST(ReferenceOverlap, AgreesWithTheTruthSet) {
  constexpr std::size_t kStride = test::kSlowBuild ? 6 : 1;  // brute force
  const std::vector<test::TruthCase> cases = test::truth_cases(test::Models::own, kStride);
  EXPECT_EQ(cases.size(), 3780U / kStride);
  for (const test::TruthCase& c : cases) {
    ASSERT_NO_FATAL_FAILURE(expect_truth(c));
  }
}

TEST(ReferenceOverlap, AgreesWithTheTruthSetOnModelsOfOthers) {
  SOMS_NEEDS_OUTSIDE_DATA("840 cases of the truth set");
  constexpr std::size_t kStride = test::kSlowBuild ? 8 : 1;  // brute force
  const std::vector<test::TruthCase> cases = test::truth_cases(test::Models::of_others, kStride);
  EXPECT_EQ(cases.size(), 840U / kStride);
  for (const test::TruthCase& c : cases) {
    ASSERT_NO_FATAL_FAILURE(expect_truth(c));
  }
}

}  // namespace
}  // namespace soms
