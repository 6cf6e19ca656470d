// Long queries of nearness in parts, on any number of threads.
#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/distance.h"
#include "soms/query/within.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stop_token>

namespace soms {
namespace {

constexpr std::uint64_t kTriangles = 50'000;

/// A sphere inside another: all of it is nearly as near as the nearest, so that a query takes far
/// more steps than one that is not dealt out.
struct Spheres {
  Shape inner;
  Body outer;

  explicit Spheres(Layout layout = Layout::wide)
      : inner(test::mapped(generate_sphere(kTriangles), [](const Vec3& v) { return 0.9995 * v; }),
              {.layout = layout}),
        outer(Shape(generate_sphere(kTriangles), {.layout = layout})) {}

  [[nodiscard]] Body turned() const {
    return Body(inner, Pose::from_quaternion(std::cos(0.3), 0, 0, std::sin(0.3), {}));
  }
};

TEST(DistanceThreads, AnswersAndCostsAreThoseOfOneThread) {
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const Spheres spheres(layout);
    const Body inner = spheres.turned();
    const Distance one = distance(inner, spheres.outer);
    ASSERT_TRUE(one.triangles);
    EXPECT_GT(one.distance.lower, 0);
    const double d = one.distance.upper;
    const Within near = within(inner, spheres.outer, d);
    const Within far = within(inner, spheres.outer, std::nextafter(one.distance.lower, 0));
    EXPECT_TRUE(near.within);
    EXPECT_FALSE(far.within);
    for (const int threads : {2, 3, 8}) {
      SCOPED_TRACE(threads);
      const Limits limits{.threads = threads};
      EXPECT_EQ(distance(inner, spheres.outer, {}, limits), one);
      EXPECT_EQ(within(inner, spheres.outer, d, limits), near);
      EXPECT_EQ(within(inner, spheres.outer, std::nextafter(one.distance.lower, 0), limits), far);
    }
  }
}

// Pieces of the inner sphere are queries that end before there are parts.
TEST(DistanceThreads, PartsFindWhatQueriesOfPiecesFind) {
  constexpr std::uint32_t kPiece = 100;
  constexpr std::uint64_t kAlone = 8192;  // steps of one node test or more
  const Spheres spheres;
  const Pose pose = spheres.turned().pose;
  const Distance whole = distance(spheres.turned(), spheres.outer);
  ASSERT_TRUE(whole.triangles);
  EXPECT_GT(whole.cost.node_tests, 64 * kAlone);  // a step has 64 of them at most
  const MeshView& inner = spheres.inner.mesh();
  Distance best;
  best.distance.lower = std::numeric_limits<double>::infinity();
  for (std::uint32_t first = 0; first < inner.triangles.size(); first += kPiece) {
    Mesh piece;
    piece.vertices.assign(inner.vertices.begin(), inner.vertices.end());
    const auto begin = inner.triangles.begin() + first;
    piece.triangles.assign(begin,
                           begin + std::min<std::ptrdiff_t>(kPiece, inner.triangles.end() - begin));
    const Distance d = distance(Body(Shape(piece), pose), spheres.outer);
    EXPECT_LT(d.cost.node_tests, kAlone);
    if (d.distance.lower < best.distance.lower) {
      best = d;
      best.triangles->a += first;
    }
  }
  EXPECT_EQ(whole.distance, best.distance);
  EXPECT_EQ(whole.triangles, best.triangles);
}

// Wherever a deadline ends it, a bound holds the distance.
TEST(DistanceThreads, ADeadlineLeavesABracketThatHolds) {
  const Spheres spheres;
  const Body inner = spheres.turned();
  const Distance whole = distance(inner, spheres.outer);
  for (const int threads : {1, 2}) {
    for (std::int64_t us = 0; us < 60'000; us = us * 2 + 500) {
      const auto deadline = std::chrono::steady_clock::now() + std::chrono::microseconds(us);
      const Distance cut =
          distance(inner, spheres.outer, {}, {.threads = threads, .deadline = deadline});
      EXPECT_LE(cut.distance.lower, whole.distance.lower);
      EXPECT_GE(cut.distance.upper, whole.distance.upper);
      const auto another = std::chrono::steady_clock::now() + std::chrono::microseconds(us);
      const Within near = within(inner, spheres.outer, whole.distance.upper * 2,
                                 {.threads = threads, .deadline = another});
      EXPECT_TRUE(near.within || near.at_least <= whole.distance.lower);
    }
  }
}

TEST(DistanceThreads, AStopEndsAllParts) {
  const Spheres spheres;
  std::stop_source source;
  source.request_stop();
  try {
    static_cast<void>(
        distance(spheres.turned(), spheres.outer, {}, {.threads = 2, .stop = source.get_token()}));
    ADD_FAILURE() << "not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

}  // namespace
}  // namespace soms
