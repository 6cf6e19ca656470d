// What distance queries cost where all is equally near, far, nested or concentric: counted, not
// timed.
#include "soms/generate/shapes.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"
#include "soms/query/within.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/allocation.h"
#include "tests/support/bodies.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace soms {
namespace {

constexpr std::uint64_t kMostMemory = std::uint64_t{64} << 20;

/// A square of `n` x `n` unit squares of two triangles each at height z, in shuffled order.
Mesh grid(std::uint32_t n, double z) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y), z});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  Rng rng(n);
  for (std::size_t i = mesh.triangles.size(); i > 1; --i) {
    std::swap(mesh.triangles[i - 1], mesh.triangles[rng.below(i)]);
  }
  return mesh;
}

/// The least pair of two such grids: that of their shadows, which overlap where triangles tie.
TrianglePair least_tie(const Mesh& a, const Mesh& b) {
  const auto flat = [](const Vec3& v) { return Vec3{v.x, v.y, 0}; };
  Mesh first = test::mapped(a, flat);
  first.triangles.resize(1);  // each has ties, so the least pair has triangle 0
  return reference::overlap(first, {}, test::mapped(b, flat), {}).pairs.front();
}

/// Asks in every way; each uses little memory and gives the one answer.
void expect_little_memory(const Mesh& a, const Mesh& b, double gap) {
  const Body x(a);
  const Body y(b);
  const Distance first = distance(x, Body(y.shape, Pose::translation(0, 0, 1)));
  EXPECT_EQ(first.distance, (Bracket{gap + 1, gap + 1}));
  for (const int threads : {1, 2}) {
    const test::AllocationWatch watch;
    const Distance d = distance(x, y, {}, {.threads = threads});
    EXPECT_LT(watch.peak(), kMostMemory);
    EXPECT_EQ(d.distance, (Bracket{gap, gap}));
    EXPECT_EQ(d.triangles, least_tie(a, b));
  }
  const test::AllocationWatch watch;
  const Distance exchanged = distance(y, x);
  EXPECT_EQ(exchanged.triangles, least_tie(b, a));
  EXPECT_TRUE(within(x, y, gap).within);
  EXPECT_FALSE(within(x, y, std::nextafter(gap, 0)).within);
  EXPECT_TRUE(distance(x, y, {.at_most = std::nextafter(gap, 0)}).farther);
  EXPECT_LT(watch.peak(), kMostMemory);
}

// 13 triangles of one grid touch each shadow: a million pairs tie.
TEST(DistanceGrowth, AMillionTiesTakeLittleMemory) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  expect_little_memory(grid(200, 0), grid(200, 0.25), 0.25);
}

// The same of one square with all triangles of a grid.
TEST(DistanceGrowth, AMillionTiesOfTwoTrianglesTakeLittleMemory) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  constexpr double kSide = 700;
  const Mesh square = test::soup_body({{{0, 0, 0}, {kSide, 0, 0}, {kSide, kSide, 0}},
                                       {{0, 0, 0}, {kSide, kSide, 0}, {0, kSide, 0}}});
  expect_little_memory(square, grid(700, 0.25), 0.25);
}

/// Cost of a query.
std::uint64_t nodes_of(const Body& a, const Body& b) {
  return distance(a, b).cost.node_tests;
}

// Farther away the moved vertices themselves round to a few places, where most pairs tie.
TEST(DistanceGrowth, FarBodiesCostNoMoreThanThreeTimesNearOnes) {
  for (const std::uint64_t triangles : {100U, 1000U, 20000U}) {
    const Shape knot(generate_knot(triangles));
    const Body fixed(knot);
    const auto apart = [&](double by) {
      return Body(knot,
                  Pose::from_quaternion(0.8, 0.36, 0.48, 0, {0.6 * by, 0.64 * by, 0.48 * by}));
    };
    const std::uint64_t near = nodes_of(fixed, apart(3 * 2));
    for (const double by : {6e1, 6e2, 6e3, 6e4, 6e5, 1e9, 1e12}) {
      EXPECT_LE(nodes_of(fixed, apart(by)), 3 * near) << triangles << ' ' << by;
      EXPECT_LE(nodes_of(apart(by), fixed), 3 * near) << triangles << ' ' << by;
    }
  }
}

// As far away together, both bodies are as near as before.
TEST(DistanceGrowth, BodiesFarFromTheOriginCostNoMoreThanThreeTimesThoseAtIt) {
  const Shape knot(generate_knot(1000));
  const auto cost_at = [&](const Vec3& place) {
    return nodes_of(
        Body(knot, Pose::translation(place.x, place.y, place.z)),
        Body(knot, Pose::from_quaternion(0.8, 0.36, 0.48, 0, place + Vec3{1.5, 1.25, 1})));
  };
  const std::uint64_t near = cost_at({});
  for (const double by : {1e3, 1e6, 1e8}) {
    EXPECT_LE(cost_at({by, -by, 0.5 * by}), 3 * near) << by;
  }
}

Shape scaled(const Mesh& mesh, double factor) {
  return Shape(test::mapped(mesh, [&](const Vec3& v) { return factor * v; }));
}

// All of each sphere is nearly as near as the nearest: the work grows with the size, not faster.
TEST(DistanceGrowth, ConcentricSpheresCostNoMoreThanTheirSize) {
  std::array<std::uint64_t, 2> pairs{};
  std::array<std::uint64_t, 2> nodes{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Mesh ball = generate_sphere(k == 0 ? 2520 : 10080);
    const Body inner(scaled(ball, 0.5));
    const Body outer{Shape(ball)};
    const test::AllocationWatch watch;
    const Distance d = distance(inner, outer);
    EXPECT_LT(watch.peak(), kMostMemory);
    EXPECT_GT(d.distance.lower, 0.49);
    EXPECT_LT(d.distance.upper, 0.5);
    EXPECT_EQ(d.distance, distance(outer, inner).distance);
    EXPECT_TRUE(within(inner, outer, d.distance.upper).within);
    EXPECT_FALSE(within(inner, outer, std::nextafter(d.distance.lower, 0)).within);
    pairs[k] = d.cost.triangle_tests;
    nodes[k] = d.cost.node_tests;
  }
  EXPECT_LE(pairs[1], 8 * pairs[0] + 1000);
  EXPECT_LE(nodes[1], 8 * nodes[0] + 1000);
}

TEST(DistanceGrowth, ConcentricSpheresAnswerAsBruteForce) {
  const Mesh ball = generate_sphere(360);
  const Body outer{Shape(ball)};
  for (const double factor : {0.5, 0.9, 1.0, 1.5}) {
    const Body inner(scaled(ball, factor));
    const test::PairTruth truth = test::truth_of(inner, outer);
    for (const test::QueryRow& row : test::query_table()) {
      for (const double length : test::lengths_around(row, truth.distance.distance)) {
        const test::Answer answer = row.ask(inner, outer, {.length = length}, {});
        EXPECT_EQ(row.fault(answer, truth, inner, outer, length), "")
            << row.name << " at " << length << ": " << row.text(answer);
      }
    }
  }
}

// A knot deep in a ball: free, and hardly more work than beside it.
TEST(DistanceGrowth, ABodyInsideAnotherIsAnsweredAsBruteForce) {
  const Body ball{scaled(generate_sphere(360), 2.5)};
  const Shape knot(generate_knot(240));
  test::for_each_case("growth/inside", 6, [&](Rng& rng) {
    const Body inside(knot, Pose::from_quaternion(0.8, 0.36, 0, 0.48,
                                                  {rng.uniform(-1, 1), rng.uniform(-1, 1), 0}));
    const test::PairTruth truth = test::truth_of(inside, ball);
    for (const test::QueryRow& row : test::query_table()) {
      for (const double length : test::lengths_around(row, truth.distance.distance)) {
        const test::Answer answer = row.ask(inside, ball, {.length = length}, {});
        ASSERT_EQ(row.fault(answer, truth, inside, ball, length), "")
            << row.name << " at " << length << ": " << row.text(answer);
      }
    }
  });
}

TEST(DistanceGrowth, FarBodiesCostWhatTheirNearestTrianglesDo) {
  // A traversal of pairs of nodes looks at some 20,000 boxes here.
  Rng rng(5);
  const Shape knot(generate_knot(20000));
  for (const double apart : {100.0, 1e4, 1e6}) {
    Body far(knot, test::awkward_rotation(rng));
    far.pose.m[3] = apart;
    const Distance answer = distance(far, Body(knot));
    EXPECT_LT(answer.cost.node_tests, 4000U) << apart;
    EXPECT_LT(answer.cost.triangle_tests, 4000U) << apart;
  }
}

TEST(DistanceGrowth, FarGridsTieInAllTheirTriangles) {
  const Mesh below = grid(40, 0);
  const Mesh above = grid(30, 5000);
  const Distance answer = distance(Body(below), Body(above));
  EXPECT_EQ(answer.distance, (Bracket{5000, 5000}));
  EXPECT_EQ(answer.triangles, least_tie(below, above));
}

TEST(DistanceGrowth, TheLeastOverlapRulesOutMostOthers) {
  const Body a(generate_knot(20000));
  Body b(a.shape);
  b.pose = Pose::translation(0.3, 0.1, 0.2);
  const Overlap all = overlap(a, b);
  const Overlap first = overlap(a, b, {.mode = OverlapMode::first});
  ASSERT_FALSE(all.pairs.empty());
  EXPECT_EQ(first.pairs.front(), all.pairs.front());
  EXPECT_LT(4 * first.cost.node_tests, all.cost.node_tests);
}

}  // namespace
}  // namespace soms
