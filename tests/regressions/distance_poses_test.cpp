// Faults that users of other libraries reported, as far as they speak of distances of bodies that
// are posed, moved on, turned, or far away.
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/query/overlap_inputs.h"
#include "tests/regressions/bodies.h"
#include "tests/support/bodies.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;

constexpr double kNoEnd = std::numeric_limits<double>::infinity();

void expect_near(const Vec3& point, const Vec3& expected, double most) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(point[axis], expected[axis], most) << "axis " << axis;
  }
}

/// Expects the answers of brute force, and returns the distance.
Distance expect_right(const Body& a, const Body& b) {
  EXPECT_EQ(test::first_fault(a, b), "");
  return distance(a, b);
}

TEST(Regression, R35TheSecondAnswerIsOfTheSecondPose) {
  const Body fixed{box_body({-1, -1, -1}, {1, 1, 1}, 3)};
  Body mover{box_body({-1, -1, -1}, {1, 1, 1}, 3), Pose::translation(1.5, 0.25, 0.125)};
  Distance near = distance(mover, fixed);
  Within clear = within(mover, fixed, 0.25);
  EXPECT_EQ(near.distance, (Bracket{0, 0}));
  EXPECT_TRUE(near.triangles);
  EXPECT_TRUE(clear.within);
  EXPECT_TRUE(clear.triangles);
  const Distance first = near;
  mover.pose = Pose::translation(2.5, 0.25, 0.125);
  near = distance(mover, fixed);
  EXPECT_EQ(near.distance, (Bracket{0.5, 0.5}));
  EXPECT_FALSE(near.farther);
  near = distance(mover, fixed, {.at_most = 0.25});
  EXPECT_TRUE(near.farther);
  EXPECT_FALSE(near.triangles);
  clear = within(mover, fixed, 0.25);
  EXPECT_FALSE(clear.within);
  EXPECT_FALSE(clear.triangles);
  mover.pose = Pose::translation(1.5, 0.25, 0.125);
  EXPECT_EQ(distance(mover, fixed), first);
  // In a batch no answer holds anything of the one before.
  const std::array poses{mover.pose, Pose::translation(2.5, 0.25, 0.125), mover.pose};
  const DistanceBatch batch = distance(mover.shape, poses, fixed, {.at_most = 0.25});
  EXPECT_EQ(batch.at(0), distance(mover, fixed, {.at_most = 0.25}));
  EXPECT_EQ(batch.at(1), near);
  EXPECT_EQ(batch.at(2), batch.at(0));
}

// Points are in the world, whatever the poses: the corner that was turned to the other body.
TEST(Regression, R35PointsAreInTheWorld) {
  const Mesh box = box_body({0, 0, 0}, {3, 1, 2});
  // A quarter turn about z: the box becomes [-1, 0] x [0, 3] x [0, 2].
  Pose turned;
  turned.m = {0, -1, 0, 100, 1, 0, 0, 200, 0, 0, 1, 300};
  const Body a(box, turned);
  const Body b(box_body({0, 0, 0}, {1, 1, 1}), Pose::translation(102, 205, 304));
  const Distance d = distance(a, b);
  EXPECT_EQ(d.point_a, (Vec3{100, 203, 302}));
  EXPECT_EQ(d.point_b, (Vec3{102, 205, 304}));
  EXPECT_EQ(d.distance.lower, std::sqrt(12.0));
  const Distance back = distance(b, a);
  EXPECT_EQ(back.point_a, d.point_b);
  EXPECT_EQ(back.point_b, d.point_a);
  const Within near = within(a, b, 4);
  EXPECT_TRUE(near.within);
  ASSERT_TRUE(near.triangles);
  const Bracket of_pair = test::distance_of_pair(a, b, *near.triangles);
  EXPECT_EQ(test::fault_of_points(a, b, *near.triangles, near.point_a, near.point_b, of_pair), "");
}

// A corner rests on a corner, turned in any direction that leaves it the only contact.
TEST(Regression, R101PointsOfBodiesThatTouchAreTheContact) {
  const Body fixed(box_body({-1, -1, -1}, {1, 1, 1}));
  const Mesh box = box_body({0, 0, 0}, {2, 2, 2});
  test::for_each_case("regression/R101", 100, [&](Rng& rng) {
    const Vec3 axis{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double length = std::sqrt(dot(axis, axis));
    const double half = rng.uniform(-0.2, 0.2);
    const double s = std::sin(half) / length;
    const Pose pose =
        Pose::from_quaternion(std::cos(half), s * axis.x, s * axis.y, s * axis.z, {1, 1, 1});
    const Distance d = distance(fixed, Body(box, pose));
    ASSERT_EQ(d.distance, (Bracket{0, 0}));
    expect_near(d.point_a, {1, 1, 1}, 4 * 0x1p-51);
    expect_near(d.point_b, {1, 1, 1}, 4 * 0x1p-51);
  });
}

// The rule for points of parallel faces is one of the overlap of both, so they move with the body.
TEST(Regression, R108PointsOfParallelFacesDoNotJump) {
  const Body plate(box_body({-8, -8, -1}, {8, 8, 0}));
  const Shape box(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  // Above one triangle of the plate, across its diagonal, and over its edge.
  for (const Vec3& start : {Vec3{3, -4, 1.5}, Vec3{0.25, 0.125, 1.5}, Vec3{7.9, 2, 1.5}}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3 at = start;
      Distance before = distance(Body(box, Pose::translation(at.x, at.y, at.z)), plate);
      for (int step = 0; step < 40; ++step) {
        const double old = at[axis];
        at[axis] = std::nextafter(old, kNoEnd);
        const Distance d = distance(Body(box, Pose::translation(at.x, at.y, at.z)), plate);
        ASSERT_EQ(d.triangles, before.triangles);
        // Each answer is off by at most 4 units in the last place of 8.
        const double most = (at[axis] - old) + 8 * 0x1p-49;
        expect_near(d.point_a, before.point_a, most);
        expect_near(d.point_b, before.point_b, most);
        ASSERT_EQ(d.distance, (Bracket{at.z - 0.5, at.z - 0.5}));
        before = d;
      }
    }
  }
}

// As near, so far: boxes that all tie in float are no more work.
TEST(Regression, R112FarBodiesCostNoMoreThanNearOnes) {
  const Shape knot(generate_knot(1000));
  const auto apart = [&](double by, const Vec3& direction) {
    const Vec3 shift = direction * by;
    return Body(knot, Pose::from_quaternion(0.8, 0.36, 0.48, 0, shift));
  };
  const Body fixed(knot);
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0.48, 0.6, 0.64}, Vec3{0, 0, -1}}) {
    const std::uint64_t near = distance(fixed, apart(6, direction)).cost.node_tests;
    for (const double by : {20.0, 200.0, 2e3, 2e4, 2e5, 6e5, 1e9}) {
      SCOPED_TRACE(by);
      const Body far = apart(by, direction);
      const Distance d = distance(fixed, far);
      EXPECT_LE(d.cost.node_tests, 3 * near);
      EXPECT_LE(distance(far, fixed).cost.node_tests, 3 * near);
      EXPECT_EQ(d.distance.upper, std::nextafter(d.distance.lower, kNoEnd));
      EXPECT_TRUE(within(fixed, far, d.distance.upper).within);
      EXPECT_FALSE(within(fixed, far, d.distance.lower).within);
    }
  }
}

TEST(Regression, R112FarBodiesAnswerAsBruteForce) {
  const Shape knot(generate_knot(160));
  for (const double by : {6.0, 600.0, 6e5, 1e9, 1e14, 0x1p80}) {
    SCOPED_TRACE(by);
    expect_right(Body(knot),
                 Body(knot, Pose::from_quaternion(0.8, 0.36, 0.48, 0, {by, by / 3, by / 7})));
  }
}

/// A rotation off orthonormal by 9e-7, and a shift: one column leans on another, or is too long.
Pose sheared(Rng& rng) {
  Pose pose = test::deep_pose(rng);
  const std::size_t from = rng.below(3);
  const std::size_t to = rng.below(3);
  const double off = (rng.below(2) == 0 ? 9e-7 : -9e-7) * (from == to ? 0.5 : 1);
  for (std::size_t row = 0; row < 3; ++row) {
    pose.m[4 * row + to] += off * pose.m[4 * row + from];
    pose.m[4 * row + 3] = rng.uniform(-3, 3);
  }
  return pose;
}

// Such poses change lengths by 4.5e-7 of themselves: more than what sets the nearest pair apart.
TEST(Regression, R113PosesThatAreOffKeepTheNearestPair) {
  const Shape ball(generate_sphere(168));
  std::size_t apart = 0;
  test::for_each_case("regression/R113", 40, [&](Rng& rng) {
    const Distance d = expect_right(Body(ball, sheared(rng)), Body(ball, sheared(rng)));
    apart += d.distance.lower > 0 ? 1 : 0;
  });
  EXPECT_GT(apart, 20U);
}

}  // namespace
}  // namespace soms
