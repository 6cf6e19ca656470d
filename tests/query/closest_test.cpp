// Errors, empty meshes, ends before the end, and large batches of points.
#include "soms/query/closest.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/print.h"
#include "soms/query/reference/closest.h"

#include "tests/support/allocation.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const Body& cube() {
  static const Body body(test::box_body({-1, -1, -1}, {1, 1, 1}));
  return body;
}

template <class Ask>
void expect_error(ErrorKind kind, const std::string& place, const Ask& ask) {
  try {
    static_cast<void>(ask());
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_NE(error.place().find(place), std::string::npos) << error.place();
  }
}

TEST(Closest, NamesFeatures) {
  const Closest face = closest(cube(), {0.25, 0.5, 3});
  EXPECT_EQ(face.distance, (Bracket{2, 2}));
  EXPECT_EQ(face.point, (Vec3{0.25, 0.5, 1}));
  EXPECT_EQ(face.feature, TriangleFeature::face);
  EXPECT_EQ(closest(cube(), {3, 0.25, 3}).feature, TriangleFeature::edge);
  const Closest corner = closest(cube(), {2, 2, 2});
  EXPECT_EQ(corner.feature, TriangleFeature::vertex);
  EXPECT_EQ(corner.point, (Vec3{1, 1, 1}));
  EXPECT_EQ(corner.distance.upper, std::nextafter(corner.distance.lower, 2));
}

TEST(Closest, PointsInsideAreAboveZeroAway) {
  const Closest inside = closest(cube(), {0.5, 0, 0});
  EXPECT_EQ(inside.distance, (Bracket{0.5, 0.5}));
  EXPECT_EQ(inside.point, (Vec3{1, 0, 0}));
}

TEST(Closest, FollowsThePose) {
  const Body moved(cube().shape, Pose::translation(10, 0, 0));
  EXPECT_EQ(closest(moved, {10, 0, 4}).distance, (Bracket{3, 3}));
}

TEST(Closest, NothingIsNearAnEmptyMesh) {
  const Body empty{Mesh{}};
  const Closest answer = closest(empty, {1, 2, 3}, {.at_most = 1});
  EXPECT_EQ(answer, (Closest{.distance = {kInfinity, kInfinity}}));
  const std::array points{Vec3{1, 2, 3}, Vec3{}};
  EXPECT_EQ(closest(empty, points).at(1), (Closest{.distance = {kInfinity, kInfinity}}));
  const NearTriangles near = nearest_triangles(empty, points, 5);
  EXPECT_EQ(near.offsets, (std::vector<std::uint64_t>{0, 0, 0}));
  EXPECT_EQ(near.size(), 2U);
}

TEST(Closest, NoPointsHaveNoAnswers) {
  EXPECT_EQ(closest(cube(), std::span<const Vec3>{}).size(), 0U);
  EXPECT_EQ(near_triangles(cube(), {}, 1).offsets, std::vector<std::uint64_t>{0});
  const std::array points{Vec3{}};
  EXPECT_TRUE(nearest_triangles(cube(), points, 0).triangle.empty());
}

TEST(Closest, NamesThePointAtFault) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, kNan, 0}, {kInfinity, 0, 0}};
  expect_error(ErrorKind::not_finite, "point 1: y", [&] { return closest(cube(), points); });
  expect_error(ErrorKind::not_finite, "point 1: y",
               [&] { return nearest_triangles(cube(), points, 2); });
  expect_error(ErrorKind::not_finite, "point 1: y",
               [&] { return near_triangles(cube(), points, 2); });
  expect_error(ErrorKind::out_of_range, "point: z", [] {
    return closest(cube(), Vec3{0, 0, -0x1.8p300});
  });
  EXPECT_GT(closest(cube(), Vec3{0x1p300, 0, 0}).distance.lower, 0);
}

TEST(Closest, RefusesLengthsThatAreNone) {
  for (const double length : {-1.0, kNan}) {
    expect_error(ErrorKind::usage, "at_most",
                 [&] { return closest(cube(), Vec3{}, {.at_most = length}); });
    expect_error(ErrorKind::usage, "radius", [&] {
      const std::array points{Vec3{}};
      return near_triangles(cube(), points, length);
    });
  }
}

TEST(Closest, RefusesAPoseThatIsNotRigid) {
  Pose pose;
  pose.m[0] = 2;
  expect_error(ErrorKind::not_rigid, "pose",
               [&] { return closest(Body(cube().shape, pose), Vec3{}); });
}

TEST(Closest, EndsWhenItIsStopped) {
  const std::array points{Vec3{}};
  std::stop_source source;
  source.request_stop();
  const Limits stopped{.stop = source.get_token()};
  expect_error(ErrorKind::cancelled, "", [&] { return closest(cube(), Vec3{}, {}, stopped); });
  expect_error(ErrorKind::cancelled, "", [&] { return closest(cube(), points, {}, stopped); });
  expect_error(ErrorKind::cancelled, "",
               [&] { return nearest_triangles(cube(), points, 1, {}, stopped); });
}

TEST(Closest, APastDeadlineCutsEverything) {
  const Limits late{.deadline = std::chrono::steady_clock::time_point()};
  const Closest answer = closest(cube(), {3, 0, 0}, {}, late);
  EXPECT_EQ(answer.coverage, Coverage::cut);
  EXPECT_FALSE(answer.farther);
  EXPECT_LE(answer.distance.lower, 2);
  EXPECT_EQ(answer.distance.upper, kInfinity);
  const std::array points{Vec3{3, 0, 0}};
  EXPECT_EQ(closest(cube(), points, {}, late).at(0), answer);
  EXPECT_EQ(nearest_triangles(cube(), points, 3, {}, late).coverage[0], Coverage::cut);
}

// All triangles of a sphere are about equally far from its center: many steps, which deadlines cut
// anywhere.
TEST(Closest, WhatACutAnswerSaysHolds) {
  const Body sphere(generate_sphere(40000));
  const Vec3 center{1e-9, 0, 0};
  const Bracket truth = closest(sphere, center).distance;
  int cut = 0;
  double wait = 10;
  for (bool complete = false; !complete; wait *= 1.1) {
    const auto deadline = std::chrono::steady_clock::now() +
                          std::chrono::microseconds(static_cast<std::int64_t>(wait));
    const Closest answer = closest(sphere, center, {}, {.deadline = deadline});
    complete = answer.coverage == Coverage::complete;
    cut += complete ? 0 : 1;
    ASSERT_LE(answer.distance.lower, truth.lower);
    ASSERT_GE(answer.distance.upper, truth.upper);
  }
  EXPECT_GT(cut, 0);
}

// More triangles are equally near in floats than wait to be decided.
TEST(Closest, ManyNearlyEqualTrianglesAreDecided) {
  const Body sphere(generate_sphere(20000));
  for (const Vec3& point : {Vec3{}, Vec3{1e-15, 0, 0}, Vec3{0, 1e-12, -1e-12}}) {
    Closest answer = closest(sphere, point);
    EXPECT_GT(answer.cost.triangle_tests, 4096U);
    answer.cost = {};
    Closest expected = reference::closest_by_brute_force(sphere, point);
    expected.cost = {};
    EXPECT_EQ(answer, expected);
  }
}

/// Points with whole coordinates as far from the origin as each other, each the tip of a triangle
/// that points outward.
Mesh spikes(int squared) {
  Mesh mesh;
  const int most = static_cast<int>(std::sqrt(squared));
  for (int x = -most; x <= most; ++x) {
    for (int y = -most; y <= most; ++y) {
      const int rest = squared - x * x - y * y;
      const int z = rest < 0 ? -1 : static_cast<int>(std::lround(std::sqrt(rest)));
      if (z > 0 && z * z == rest) {
        const Vec3 tip{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const Vec3 aside{0, 0.25, 0};
        mesh.vertices.insert(mesh.vertices.end(), {tip, 1.25 * tip + aside, 1.25 * tip - aside});
        mesh.triangles.push_back({first, first + 1, first + 2});
      }
    }
  }
  return mesh;
}

// Whole numbers took 5 KB for each.
TEST(NearTriangles, ExactTiesTakeLittleMemory) {
  const Body body(spikes(160'001));
  const std::size_t count = body.shape.mesh().triangles.size();
  ASSERT_GT(count, 500U);
  const std::array points{Vec3{}};
  const test::AllocationWatch watch;
  const NearTriangles near = near_triangles(body, points, 401);
  EXPECT_LT(watch.peak(), 65'536 + 1024 * count);
  EXPECT_GE(near.cost.exact_tests, count);
  ASSERT_EQ(near.triangle.size(), count);
  EXPECT_TRUE(std::is_sorted(near.triangle.begin(), near.triangle.end()));
  const Bracket distance = closest(body, Vec3{}).distance;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(near.lower[i], distance.lower);
    EXPECT_EQ(near.upper[i], distance.upper);
  }
}

// Large batches are answered along a curve; the rows keep their places.
TEST(Closest, LargeBatchesAreTheirSingleQueries) {
  const Body knot(generate_knot(20000));
  Rng rng(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    points.push_back({rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)});
  }
  const ClosestBatch batch = closest(knot, points, {}, {.threads = 2});
  EXPECT_EQ(batch, closest(knot, points));
  const NearTriangles near = nearest_triangles(knot, points, 3, {}, {.threads = 2});
  EXPECT_EQ(near, nearest_triangles(knot, points, 3));
  Cost sum;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += batch.costs[i];
    ASSERT_EQ(near.triangle[3 * i], *batch.triangle[i]);
    if (i % 50 == 0) {
      ASSERT_EQ(batch.at(i), closest(knot, points[i]));
      ASSERT_EQ(nearest_triangles(knot, std::span(points).subspan(i, 1), 3).costs[0],
                near.costs[i]);
    }
  }
  EXPECT_EQ(batch.cost, sum);
}

// Floats cannot part what is far away; that must not bring all triangles into play.
TEST(Closest, FarPointsCostLittle) {
  const Body knot(generate_knot(100000));
  for (const double far : {1e2, 1e4, 1e6, 1e9}) {
    EXPECT_LT(closest(knot, {far, 0.3 * far, -0.2 * far}).cost.triangle_tests, 500U) << far;
  }
}

}  // namespace
}  // namespace soms
