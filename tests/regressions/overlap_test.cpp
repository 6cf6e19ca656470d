// Faults that users of other libraries reported, as far as they speak of overlap: one test a
// report, each under all variations. An id is never used again.
#include "soms/query/overlap.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/overlap.h"

#include "tests/regressions/bodies.h"
#include "tests/regressions/variations.h"
#include "tests/support/bodies.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::channel_body;
using test::deep_pose;
using test::expect_overlap;
using test::mapped;
using test::overlap_under_variations;
using test::rod_body;
using test::soup_body;
using test::unit_box;

// Two walls on one axis overlap by 50 mm with all side faces flush.
TEST(Regression, R01FlushWallsThatRunIntoEachOtherOverlap) {
  expect_overlap(unit_box(), box_body({0.95, 0, 0}, {1.95, 1, 1}), true);
  expect_overlap(unit_box(), box_body({0.95, 0.002, 0}, {1.95, 1.002, 1}), true);
  // An L corner where one wall runs 0.05 too far.
  expect_overlap(box_body({0, 0, 0}, {4.05, 0.2, 3}), box_body({4, 0, 0}, {4.2, 4, 3}), true);
}

// Sharing a face overlaps, and the least gap does not.
TEST(Regression, R02AFaceSharedOrMissedByALeastGap) {
  for (const double shift : {-0x1p-30, 0.0}) {
    expect_overlap(unit_box(), box_body({1 + shift, 0, 0}, {2 + shift, 1, 1}), true);
  }
  expect_overlap(unit_box(), box_body({1 + 0x1p-30, 0, 0}, {2 + 0x1p-30, 1, 1}), false);
}

// The same members turned by a 3-4-5 rotation, exact after scaling by 5.
TEST(Regression, R03SkewedMembersThatShareAFace) {
  const auto turn = [](const Vec3& v) {
    return Vec3{3 * v.x - 4 * v.y, 4 * v.x + 3 * v.y, 5 * v.z};
  };
  const Mesh first = mapped(unit_box(), turn);
  for (const double shift : {0.0, -0x1p-20}) {
    expect_overlap(first, mapped(box_body({1 + shift, 0, 0}, {2 + shift, 1, 1}), turn), true);
  }
  expect_overlap(first, mapped(box_body({1 + 0x1p-20, 0, 0}, {2 + 0x1p-20, 1, 1}), turn), false);
}

// A triangle without area is the point or segment it is, and no more.
TEST(Regression, R04PointsAndSegmentsOverlapOnlyWhatTheyTouch) {
  const Mesh box = box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  const Vec3 away{5, 5, 5};
  expect_overlap(box, soup_body({{away, away, away}}), false);
  expect_overlap(box, soup_body({{away, {6, 6, 6}, {7, 7, 7}}}), false);
  const Vec3 on{0.5, 0, 0};
  expect_overlap(box, soup_body({{on, on, on}}), true);
}

/// Expects two triangles to be apart in all 72 orders and under all variations.
void expect_apart(const Triangle& s, const Triangle& t) {
  for (const Triangle& u : test::corner_orders(s)) {
    for (const Triangle& v : test::corner_orders(t)) {
      EXPECT_FALSE(triangles_overlap(u, v));
      EXPECT_FALSE(triangles_overlap(v, u));
    }
  }
  expect_overlap(soup_body({s}), soup_body({t}), false);
}

TEST(Regression, R05TheAnswerForTwoTrianglesHasNoOrder) {
  const auto [s, t] = test::triangles_of_r05();
  expect_apart(s, t);
}

// The first triangle is off its plane by 1e-16.
TEST(Regression, R06NearlyAlignedTrianglesApartDoNotCross) {
  expect_apart({{-0.29389262199401855, 0.40450850129127514, 0.4999999999999999},
                {-0.4755282700061798, -0.1545085012912749, 0.5},
                {0, 1.1102230246251565e-16, 0.5}},
               {{-1.2246468525851679e-16, -0.5, 0.5},
                {-0.4755282700061798, -0.5, 0.15450850129127502},
                {0, -0.5, 0}});
}

TEST(Regression, R07ParallelTrianglesOverlapAtGapZeroOnly) {
  const Mesh ground = soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  for (const double gap : {0x1p-40, 0x1p-30, 0x1p-20}) {
    expect_overlap(ground, soup_body({{{0, 0, gap}, {1, 0, gap}, {0, 1, gap}}}), false);
  }
  expect_overlap(ground, ground, true);
}

// Equal cubes cannot hold one another, so cubes this deep always cross.
TEST(Regression, R08DeepCubesAlwaysOverlap) {
  const std::size_t count = test::kSlowBuild ? 20000 : 1000000;
  Rng rng(8);
  std::vector<Pose> poses(count);
  std::generate(poses.begin(), poses.end(), [&] { return deep_pose(rng); });
  const Shape cube(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  OverlapOptions options;
  options.mode = OverlapMode::any;
  const OverlapBatch batch = overlap(cube, poses, Body(cube), options);
  EXPECT_EQ(std::count(batch.any.begin(), batch.any.end(), 1), static_cast<long>(count));
}

// Cubes that kiss, the gap swept in units of the last place: the answer is the sign of the gap.
TEST(Regression, R09KissingContactFollowsTheGapToTheLastBit) {
  test::for_each_case("regression/R09", test::kSlowBuild ? 3 : 12, [](Rng& rng) {
    test::KissingCube kiss = test::kissing_cube(rng);
    const Mesh& wall = kiss.wall;
    const Mesh& cube = kiss.cube;
    Pose& pose = kiss.pose;
    const double start = pose.m[3];
    for (int ulps = -8; ulps <= 8; ++ulps) {
      pose.m[3] = start + ulps * 0x1p-54;
      const Mesh moved = mapped(cube, [&](const Vec3& v) { return pose.apply(v); });
      const bool expected = bounds(moved).lower.x <= 0.25;
      EXPECT_EQ(overlap(Body(cube, pose), Body(wall)).any, expected);
      if (ulps % 4 == 0) {
        expect_overlap(moved, wall, expected);
      }
    }
  });
}

TEST(Regression, R10ARodInAChannelIsClear) {
  const Mesh channel = channel_body();
  expect_overlap(rod_body(), channel, false);
  const Mesh leaning = mapped(rod_body(), [](const Vec3& v) { return v + Vec3{0.35, 0, 0}; });
  expect_overlap(leaning, channel, true);
}

TEST(Regression, R11BoxesInOneRowAreApartWhenTheRootIsALeaf) {
  expect_overlap(unit_box(), box_body({0, 10, 0}, {1, 11, 1}), false);
}

TEST(Regression, R12ASliverGivesNoGhostHit) {
  const Mesh sliver = soup_body({{{14.5536213, 10.5973721, -0.0060005188},
                                  {14.5536213, 10.5969315, -3.18638134},
                                  {14.5536213, 10.5969315, -5.18637228}}});
  const Vec3 start{14.831459, 8.1905508, -4.30825043};
  const Vec3 direction{-0.0988006592, 5.96e-8, 0.000732421875};
  for (const double t : {0.0, 0.5, 1.0}) {
    const Mesh ball = mapped(generate_sphere(120),
                             [&](const Vec3& v) { return 0.2 * v + (start + t * direction); });
    expect_overlap(sliver, ball, false);
  }
}

TEST(Regression, R13SmallTrianglesAreKept) {
  const Triangle small{{0.279280782, -0.467894495, 0.105353981},
                       {0.280091137, -0.467545986, 0.104968153},
                       {0.277769983, -0.46932292, 0.105590254}};
  const Vec3 middle = (1.0 / 3) * (small.a + small.b + small.c);
  const Mesh needle = soup_body({{middle - 0.01 * cross(small.b - small.a, small.c - small.a),
                                  middle + Vec3{0.1, 0.2, 0.3}, middle + Vec3{-0.1, -0.2, -0.3}}});
  EXPECT_EQ(overlap_under_variations(soup_body({small}), needle),
            (std::vector<TrianglePair>{{0, 0}}));
}

TEST(Regression, R13ATinyKnotAnswersAsTheLargeOne) {
  const Mesh knot = generate_knot(400);
  const Pose pose = Pose::about_z(0.5, {0.25, 0.125, 0});
  const Mesh turned = mapped(knot, [&](const Vec3& v) { return pose.apply(v); });
  const auto pairs = overlap_under_variations(knot, turned);
  EXPECT_GT(pairs.size(), 20U);
  const auto tiny = [](const Vec3& v) { return v * 0x1p-60; };
  EXPECT_EQ(overlap(Body(mapped(knot, tiny)), Body(mapped(turned, tiny))).pairs, pairs);
}

// Every triangle meets at least itself; the variations reorder the copy.
TEST(Regression, R14ABodyAndItsCopyInOnePlace) {
  const Mesh knot = generate_knot(120);
  const auto pairs = overlap_under_variations(knot, knot);
  for (TriangleId i = 0; i < 120; ++i) {
    EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), (TrianglePair{i, i})));
  }
}

TEST(Regression, R15CoplanarSquaresOverlap) {
  const Mesh square =
      soup_body({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  const Mesh moved = mapped(square, [](const Vec3& v) { return v + Vec3{0.5, 0.5, 0}; });
  EXPECT_EQ(overlap_under_variations(square, moved),
            (std::vector<TrianglePair>{{0, 0}, {0, 1}, {1, 0}, {1, 1}}));
}

// Coplanar faces cut into many triangles: none in the middle of the face is left out.
TEST(Regression, R16EveryPairOfTwoBoxesIsListed) {
  for (const int cuts : {1, 4}) {
    const Mesh large = box_body({-1, -1, -1}, {1, 1, 1}, cuts);
    const Mesh small = box_body({-0.5, -0.5, 0.5}, {0.5, 0.5, 1.5}, cuts);
    EXPECT_FALSE(overlap_under_variations(large, small).empty());
    const Mesh standing = box_body({-0.5, -0.5, 1}, {0.5, 0.5, 2}, cuts);
    EXPECT_FALSE(overlap_under_variations(large, standing).empty());
  }
}

}  // namespace
}  // namespace soms
