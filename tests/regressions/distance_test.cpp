// Faults that users of other libraries reported, as far as they speak of distance and clearance:
// one test a report, under all variations. An id is never used again.
#include "soms/query/distance.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/query/overlap_inputs.h"
#include "tests/regressions/bodies.h"
#include "tests/regressions/variations.h"
#include "tests/support/bodies.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::expect_distance;
using test::mapped;
using test::soup_body;

/// The bracket of the real number x - y.
Bracket bracket_of_difference(double x, double y) {
  const double d = x - y;
  // What the rounding lost (Knuth's two-sum).
  const double back = x - d;
  const double lost = (x - (d + back)) + (back - y);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {lost < 0 ? std::nextafter(d, -kInfinity) : d,
          lost > 0 ? std::nextafter(d, kInfinity) : d};
}

TEST(Regression, R05TheDistanceOfTwoTrianglesHasNoOrder) {
  const Bracket expected{4.154999732971191, 4.154999732971191};
  const auto [s, t] = test::triangles_of_r05();
  for (const Triangle& u : test::corner_orders(s)) {
    for (const Triangle& v : test::corner_orders(t)) {
      EXPECT_EQ(distance(test::body_of(u), test::body_of(v)).distance, expected);
      EXPECT_EQ(distance(test::body_of(v), test::body_of(u)).distance, expected);
    }
  }
  expect_distance(soup_body({s}), soup_body({t}), expected);
}

TEST(Regression, R07ParallelTrianglesAreAsFarApartAsTheirGap) {
  const Mesh ground = soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  for (const double gap : {0x1p-40, 0x1p-30, 0x1p-20, 0.0}) {
    expect_distance(ground, soup_body({{{0, 0, gap}, {1, 0, gap}, {0, 1, gap}}}), {gap, gap});
  }
}

// The gap is the foremost corner's, to the last bit: overlap and distance agree at every step.
TEST(Regression, R09OverlapAndDistanceAgreeAtAKissingContact) {
  test::for_each_case("regression/R09-distance", test::kSlowBuild ? 3 : 12, [](Rng& rng) {
    test::KissingCube kiss = test::kissing_cube(rng);
    const double start = kiss.pose.m[3];
    for (int ulps = -8; ulps <= 8; ++ulps) {
      kiss.pose.m[3] = start + ulps * 0x1p-54;
      const Mesh moved = mapped(kiss.cube, [&](const Vec3& v) { return kiss.pose.apply(v); });
      const double gap = std::max(0.0, bounds(moved).lower.x - 0.25);
      const Body cube(kiss.cube, kiss.pose);
      const Body wall(kiss.wall);
      ASSERT_EQ(distance(cube, wall).distance, (Bracket{gap, gap}));
      ASSERT_EQ(distance(wall, cube).distance, (Bracket{gap, gap}));
      ASSERT_EQ(overlap(cube, wall).any, gap == 0);
      ASSERT_EQ(within(cube, wall, 0).within, gap == 0);
      ASSERT_TRUE(within(cube, wall, gap).within);
      ASSERT_TRUE(gap == 0 || !within(cube, wall, std::nextafter(gap, 0)).within);
      if (ulps % 4 == 0) {
        expect_distance(moved, kiss.wall, {gap, gap});
      }
    }
  });
}

TEST(Regression, R10ARodInAChannelIsAsFarAsItsWalls) {
  const Mesh rod = test::rod_body();
  const Bracket d = test::distance_under_variations(rod, test::channel_body()).distance;
  // Its rim has points at -0.2 and 0.2, but for the rounding of sine and cosine.
  EXPECT_NEAR(d.lower, 0.3, 1e-12);
  EXPECT_NEAR(d.upper, 0.3, 1e-12);
  const Mesh leaning = mapped(rod, [](const Vec3& v) { return v + Vec3{0.35, 0, 0}; });
  expect_distance(leaning, test::channel_body(), {0, 0});
}

// Of surfaces: a body inside another is free, and as far as the nearer wall.
TEST(Regression, R17ABodyInsideAnotherHasADistanceFromItsSurface) {
  const Mesh inner = box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  const Mesh outer = box_body({-5, -5, -5}, {5, 5, 5});
  expect_distance(inner, outer, {4.5, 4.5});
  test::expect_overlap(inner, outer, false);
  const Mesh ball = mapped(generate_sphere(480), [](const Vec3& v) { return 20 * v; });
  const Mesh below = mapped(inner, [](const Vec3& v) { return v - Vec3{0, 0, 5}; });
  // A cone of 16 sides with its base at z = -60.
  std::vector<Triangle> sides;
  for (int i = 0; i < 16; ++i) {
    const auto rim = [](int k) {
      const double angle = 2 * 3.141592653589793 * (k % 16) / 16;
      return Vec3{100 * std::cos(angle), 100 * std::sin(angle), -60};
    };
    sides.push_back({{0, 0, 80}, rim(i), rim(i + 1)});
    sides.push_back({{0, 0, -60}, rim(i + 1), rim(i)});
  }
  const std::vector<Body> nested{Body(below), Body(ball), Body(soup_body(sides))};
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < nested.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Distance d = distance(nested[i], nested[j]);
      EXPECT_GT(d.distance.lower, 1);
      EXPECT_TRUE(d.triangles);
      EXPECT_FALSE(within(nested[i], nested[j], 1).within);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 3U);
}

// Distance has no sign: bodies that collide are at 0, and the least pair that overlaps is named.
TEST(Regression, R24BodiesThatCollideAreAtDistanceZero) {
  const Mesh fixed = box_body({0, 0, 0}, {1, 1, 1});
  const Mesh mover = box_body({0.5, 0, 0}, {1.5, 1, 1});
  const Distance d = test::distance_under_variations(mover, fixed);
  EXPECT_EQ(d.distance, (Bracket{0, 0}));
  EXPECT_EQ(d.triangles, overlap(Body(mover), Body(fixed)).pairs.front());
}

TEST(Regression, R25CubesThatTouchAreAtDistanceZero) {
  for (const Vec3& by : {Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{1, 0.25, 0.125}}) {
    const Mesh other = box_body(by, by + Vec3{1, 1, 1});
    expect_distance(test::unit_box(), other, {0, 0});
    test::expect_overlap(test::unit_box(), other, true);
  }
}

TEST(Regression, R26ThePointsLieOnTheNamedTriangles) {
  std::size_t apart = 0;
  test::for_each_case("regression/R26", 50, [&](Rng& rng) {
    const Body a(test::awkward_mesh(rng, 60));
    const Body b(test::awkward_mesh(rng, 60),
                 test::moving(test::awkward_rotation(rng), {},
                              {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)}));
    const Distance d = distance(a, b);
    ASSERT_TRUE(d.triangles);
    ASSERT_EQ(test::fault_of_points(a, b, *d.triangles, d.point_a, d.point_b, d.distance), "");
    ASSERT_EQ(test::distance_of_pair(a, b, *d.triangles), d.distance);
    apart += d.distance.lower > 0 ? 1 : 0;
  });
  EXPECT_GT(apart, 25U);
}

/// A unit sphere of `slices` by `stacks`, poles at z = -1 and 1.
Mesh sphere(int slices, int stacks) {
  const double pi = 3.141592653589793;
  const auto at = [&](int i, int j) {
    if (i == 0 || i == stacks) {
      return Vec3{0, 0, i == 0 ? 1.0 : -1.0};
    }
    const double polar = pi * i / stacks;
    const double around = 2 * pi * (j % slices) / slices;
    return Vec3{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                std::cos(polar)};
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < stacks; ++i) {
    for (int j = 0; j < slices; ++j) {
      if (i > 0) {
        triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      }
      if (i + 1 < stacks) {
        triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
      }
    }
  }
  return soup_body(triangles);
}

TEST(Regression, R27SpheresOfAnyFinenessAreOneApart) {
  for (const auto& [slices, stacks] : {std::pair(8, 4), std::pair(16, 8)}) {
    const Mesh ball = sphere(slices, stacks);
    expect_distance(ball, mapped(ball, [](const Vec3& v) { return v + Vec3{0, 0, 3}; }), {1, 1});
  }
  for (const auto& [slices, stacks] :
       {std::pair(8, 4), std::pair(16, 8), std::pair(32, 16), std::pair(256, 128)}) {
    SCOPED_TRACE(slices);
    const Shape ball(sphere(slices, stacks));
    const Distance d = distance(Body(ball), Body(ball, Pose::translation(0, 0, 3)));
    EXPECT_EQ(d.distance, (Bracket{1, 1}));
    EXPECT_EQ(d.point_a, (Vec3{0, 0, 1}));
    EXPECT_EQ(d.point_b, (Vec3{0, 0, 2}));
    EXPECT_TRUE(within(Body(ball), Body(ball, Pose::translation(0, 0, 3)), 1).within);
    // Along x they are one apart where the equator has corners, but for the rounding of the sine.
    const Bracket beside = distance(Body(ball), Body(ball, Pose::translation(3, 0, 0))).distance;
    EXPECT_NEAR(beside.lower, 1, 1e-15);
    EXPECT_NEAR(beside.upper, 1, 1e-15);
  }
  const Body coarse(sphere(32, 16), Pose::from_quaternion(0.8, 0.36, 0.48, 0, {3, 0.25, 0.5}));
  const Body fine(sphere(16, 8));
  const test::QueryRow& row = test::query_row("distance");
  const test::Answer answer = row.ask(coarse, fine, {}, {});
  EXPECT_EQ(row.fault(answer, test::truth_of(coarse, fine), coarse, fine,
                      std::numeric_limits<double>::infinity()),
            "");
}

TEST(Regression, R28EdgesThatCrossAreNear) {
  const Triangle flat{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}};
  const auto upright = [](double z) { return Triangle{{0, -1, z}, {0, 1, z}, {0, 0, z + 1}}; };
  for (const double gap : {0.0, 0x1p-10}) {
    expect_distance(soup_body({flat}), soup_body({upright(gap)}), {gap, gap});
  }
  // Crossed edges alone: no corner is near the other triangle.
  const Triangle above{{0, -1, 0x1p-10}, {0, 1, 0x1p-10}, {0, 4, 1}};
  const Triangle below{{-1, 0, 0}, {1, 0, 0}, {4, 0, -1}};
  expect_distance(soup_body({below}), soup_body({above}), {0x1p-10, 0x1p-10});
}

TEST(Regression, R31SmallCubesHaveNoHiddenMargin) {
  for (const double side : {1.0, 0.1, 0.05, 0.01}) {
    const double h = side / 2;
    const Mesh here = box_body({-h, -h, -h}, {h, h, h});
    const Mesh there = box_body({100 - h, -h, -h}, {100 + h, h, h});
    const Bracket expected = bracket_of_difference(100 - h, h);
    expect_distance(here, there, expected);
    EXPECT_NEAR(expected.lower, 100 - side, 1e-13);
  }
}

TEST(Regression, R32BodiesNearerThanTheMarginAreWithinIt) {
  const Mesh near = box_body({1.7, 0, 0}, {2.7, 1, 1});
  expect_distance(test::unit_box(), near, bracket_of_difference(1.7, 1));
  test::for_each_variation(test::unit_box(), near, [](const test::Variation& variation) {
    const double unit = std::ldexp(1.0, variation.exponent);
    for (const double margin : {1.0, 0.75, 0.7}) {
      const Within near_by = within(variation.a, variation.b, margin * unit, variation.limits);
      EXPECT_TRUE(near_by.within) << variation.what;
      EXPECT_TRUE(near_by.triangles) << variation.what;
    }
    EXPECT_FALSE(within(variation.a, variation.b, 0.6875 * unit, variation.limits).within)
        << variation.what;
  });
}

TEST(Regression, R109ANegativeMarginIsRefused) {
  const Body box(test::unit_box());
  const std::vector<Pose> poses(3);
  const auto refused = [](const auto& query) {
    try {
      query();
      ADD_FAILURE() << "a negative margin was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage) << error.what();
    }
  };
  refused([&] { static_cast<void>(within(box, box, -0.1)); });
  refused([&] { static_cast<void>(within(box.shape, poses, box, -0.1)); });
  refused([&] { static_cast<void>(distance(box, box, {.at_most = -0.1})); });
  refused([&] { static_cast<void>(distance(box.shape, poses, box, {.at_most = -0.1})); });
  EXPECT_TRUE(within(box, box, 0).within);
}

}  // namespace
}  // namespace soms
