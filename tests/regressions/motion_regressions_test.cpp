// Faults that users of other libraries reported, as far as they speak of bodies on their way.
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/motion/first_contact.h"
#include "soms/motion/print_motion.h"
#include "soms/motion/reference/first_contact.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/tree/rule/rules.h"

#include "tests/regressions/bodies.h"
#include "tests/support/allocation.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::soup_body;

/// A point as a triangle.
Shape point_shape(const Vec3& p) {
  return Shape(soup_body({{p, p, p}}));
}

/// The surface of a capsule about the y axis, whose corners lie on it.
Mesh capsule_body(double radius, double half, int sides) {
  std::vector<Triangle> triangles;
  const int rings = sides / 2 + 1;  // the middle one stands twice, at both ends of the cylinder
  const auto corner = [&](int ring, int side) {
    const bool upper = ring > sides / 4;
    const double v = std::numbers::pi * ((upper ? ring - 1 : ring) / (sides / 2.0) - 0.5);
    const double u = 2 * std::numbers::pi * (side % sides) / sides;
    return Vec3{radius * std::cos(v) * std::cos(u), radius * std::sin(v) + (upper ? half : -half),
                radius * std::cos(v) * std::sin(u)};
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int side = 0; side < sides; ++side) {
      triangles.push_back({corner(ring, side), corner(ring + 1, side), corner(ring, side + 1)});
      triangles.push_back(
          {corner(ring + 1, side), corner(ring + 1, side + 1), corner(ring, side + 1)});
    }
  }
  return soup_body(triangles);
}

FirstContact sweep(const Shape& mover, const Vec3& from, const Vec3& by, const Body& fixed) {
  return first_contact(mover, RigidMotion::along(Pose::translation(from.x, from.y, from.z), by),
                       fixed);
}

/// A contact at this time, bracketed by doubles next to each other.
void expect_exactly(const FirstContact& found, double t) {
  EXPECT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_LE(found.t.lower, t);
  EXPECT_GE(found.t.upper, t);
  EXPECT_LE(found.t.upper, std::nextafter(found.t.lower, 2));
}

TEST(MotionRegressions, R12ASliverIsPassedByABallTwoUnitsAway) {
  const Body sliver(soup_body({{{14.5536213, 10.5973721, -0.0060005188},
                                {14.5536213, 10.5969315, -3.18638134},
                                {14.5536213, 10.5969315, -5.18637228}}}));
  const Shape ball(test::mapped(generate_sphere(120), [](const Vec3& v) { return 0.2 * v; }));
  const FirstContact found = sweep(ball, {14.831459, 8.1905508, -4.30825043},
                                   {-0.0988006592, 5.96e-8, 0.000732421875}, sliver);
  EXPECT_EQ(found.verdict, ContactVerdict::free);
}

TEST(MotionRegressions, R60ASweptCapsuleHitsTheTriangle) {
  const Shape capsule(capsule_body(0.265350759, 0.340350509, 128));
  const Body triangle(soup_body({{{7.3329401, 79.6109009, -26.9337997},
                                  {7.61456013, 80.2574005, -27.3008995},
                                  {7.3329401, 80.2574005, -26.9337997}}}));
  const double length = 0.149537891;
  const Vec3 by = length * Vec3{-0.929564953, -0.0281119142, 0.367584974};
  const FirstContact found = sweep(capsule, {7.74110079, 80.8543167, -27.2595482}, by, triangle);
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  // The corners of the capsule lie on it, and its sides up to 1e-4 inside.
  EXPECT_GT(found.t.lower * length, 0.0943);
  EXPECT_LT(found.t.upper * length, 0.0960);
}

TEST(MotionRegressions, R61AContactAtTheStartIsFoundWhereTheWayIsAlongTheTriangle) {
  const Shape capsule(capsule_body(0.25, 0.25, 32));
  const Body triangle(soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}}));
  const FirstContact found = sweep(capsule, {}, {-1, 0, 0}, triangle);
  EXPECT_EQ(found.verdict, ContactVerdict::started);
  EXPECT_EQ(found.t, (Bracket{0, 0}));
}

TEST(MotionRegressions, R62ASweepEndsWhereTheCubesTouch) {
  const Shape cube(box_body({-1, -1, -1}, {1, 1, 1}));
  const Body below(cube, Pose::translation(0, 10, 0));
  const FirstContact found = sweep(cube, {0, 15, 0}, {0, -4, 0}, below);
  expect_exactly(found, 0.75);
  EXPECT_EQ(found.t, (Bracket{0.75, 0.75}));
  EXPECT_EQ(found.point.y, 11);
}

TEST(MotionRegressions, R63AnEarlyGrazeDoesNotHideTheWall) {
  const Shape ball(test::mapped(generate_sphere(20000), [](const Vec3& v) { return 0.25 * v; }));
  const Mesh floor =
      soup_body({{{-9, 0, -9}, {-9, 0, 9}, {0, 0, 9}}, {{-9, 0, -9}, {0, 0, 9}, {0, 0, -9}}});
  const Mesh wall = soup_body({{{1, -9, -9}, {1, 9, -9}, {1, 0, 9}}});
  const Vec3 start{-0.78131, 0.3092001, 0};
  const Vec3 by{4, -0.3, 0};
  const FirstContact first = sweep(ball, start, by, Body(floor));
  ASSERT_EQ(first.verdict, ContactVerdict::contact);
  EXPECT_NEAR(first.t.upper, 0.199, 0.004);
  const FirstContact later = sweep(ball, start, by, Body(wall));
  ASSERT_EQ(later.verdict, ContactVerdict::contact);
  EXPECT_NEAR(later.t.upper, 0.3828, 0.0005);
}

TEST(MotionRegressions, R64BoxesFromTwentySixDirectionsMeetInTime) {
  const Shape box(box_body({-1, -1, -1}, {1, 1, 1}));
  const Body fixed(box);
  for (int k = 0; k < 27; ++k) {
    const Vec3 side{static_cast<double>(k % 3 - 1), static_cast<double>(k / 3 % 3 - 1),
                    static_cast<double>(k / 9 - 1)};
    if (side == Vec3{}) {
      continue;
    }
    const Vec3 from = 5 * side;
    expect_exactly(sweep(box, from, -8 * side, fixed), 0.375);
    const FirstContact turning = first_contact(
        box,
        RigidMotion::between(Pose::translation(from.x, from.y, from.z),
                             Pose::translation(-3 * side.x, -3 * side.y, -3 * side.z)),
        fixed);
    ASSERT_EQ(turning.verdict, ContactVerdict::contact) << k;
    EXPECT_NEAR(turning.t.lower, 0.375, 1e-12);
    EXPECT_NEAR(turning.t.upper, 0.375, 1e-12);
  }
}

TEST(MotionRegressions, R64RandomMotionsOfBoxesAreAsBruteForceHasThem) {
  Rng rng(64);
  const Shape box(box_body({-1, -0.5, -0.25}, {1, 0.5, 0.25}));
  const Body fixed(box);
  int contacts = 0;
  for (int k = 0; k < 60; ++k) {
    Pose start = test::deep_pose(rng);
    Pose end = test::deep_pose(rng);
    start.m[3] += 3;
    end.m[3] -= 3 * rng.uniform(-1, 1);
    const RigidMotion motion = RigidMotion::between(start, end);
    const FirstContact found = first_contact(box, motion, fixed);
    const FirstContact twin = reference::first_contact_by_brute_force(box, motion, fixed);
    ASSERT_EQ(found.verdict, twin.verdict) << k;
    if (twin.verdict == ContactVerdict::contact) {
      ++contacts;
      EXPECT_LE(found.t.lower, twin.t.upper) << k;
      EXPECT_GE(found.t.upper, twin.t.lower) << k;
    }
  }
  EXPECT_GT(contacts, 20);
}

// The triangle and the point are nearest at the start, 5.7e-7 apart.
TEST(MotionRegressions, R65APairThatOnlyPartsIsFree) {
  const Body point(point_shape({0.35, 0, 0.35}));
  const Shape triangle(soup_body({{{0.34604643638, 0.0027847887896, 0.3465812116},
                                   {0.35000819263, -1.5763377304e-6, 0.35001214242},
                                   {0.34903882032, -0.0015866575093, 0.34560164356}}}));
  const Distance gap = distance(Body(triangle), point);
  const Vec3 away = 1e3 * (gap.point_a - gap.point_b);
  EXPECT_EQ(sweep(triangle, {}, away, point).verdict, ContactVerdict::free);
  const RigidMotion motion = RigidMotion::along(Pose(), away);
  EXPECT_EQ(first_contact(triangle, motion, point, {.within = 5e-7}).verdict, ContactVerdict::free);
  EXPECT_EQ(first_contact(triangle, motion, point, {.within = 6e-7}).verdict,
            ContactVerdict::started);
}

TEST(MotionRegressions, R66TheFreePartOfAPathEndsBeforeItsFirstContact) {
  const Shape box(box_body({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}));
  std::vector<RigidMotion> path;
  for (int k = 0; k < 10; ++k) {
    path.push_back(RigidMotion::between(Pose::about_z(0.1 * k, {1.0 * k, 0, 0}),
                                        Pose::about_z(0.1 * (k + 1), {k + 1.0, 0, 0})));
  }
  const Mesh post = box_body({-0.01, -1, -1}, {0.01, 1, 1});
  std::vector<Triangle> triangles;
  for (const double x : {3.75, 7.75}) {
    for (TriangleId id = 0; id < post.triangles.size(); ++id) {
      const Triangle t = post.triangle(id);
      const Vec3 shift{x, 0, 0};
      triangles.push_back({t.a + shift, t.b + shift, t.c + shift});
    }
  }
  const Body posts(soup_body(triangles));
  const FirstContactBatch found = first_contact(box, path, posts);
  ASSERT_EQ(found.size(), 10U);
  const auto blocked = std::find_if(found.verdict.begin(), found.verdict.end(),
                                    [](auto verdict) { return verdict != ContactVerdict::free; });
  ASSERT_EQ(blocked - found.verdict.begin(), 3);
  const FirstContact first = found.at(3);
  EXPECT_FALSE(overlap(Body(box, path[3].pose_at(first.t.lower)), posts).any);
  EXPECT_TRUE(overlap(Body(box, path[3].pose_at(first.t.upper)), posts).any);
  EXPECT_EQ(found.at(7).verdict, ContactVerdict::contact);
}

TEST(MotionRegressions, R67AWallOfAMillimeterIsNotJumped) {
  const Shape body(box_body({-0.05, -0.05, -0.05}, {0.05, 0.05, 0.05}));
  const Body wall(box_body({5, -9, -9}, {5.001, 9, 9}));
  expect_exactly(sweep(body, {0.05, 0, 0}, {10, 0, 0}, wall), 0.49);
  const FirstContact turning =
      first_contact(body, RigidMotion::between(Pose(), Pose::about_z(1.5, {10, 0, 0})), wall);
  ASSERT_EQ(turning.verdict, ContactVerdict::contact);
  EXPECT_TRUE(overlap(Body(body, RigidMotion::between(Pose(), Pose::about_z(1.5, {10, 0, 0}))
                                     .pose_at(turning.t.upper)),
                      wall)
                  .any);
}

TEST(MotionRegressions, R68ContactsWithinOnePlaneAreFound) {
  // Two edges in one line, which meet halfway.
  const Shape edge(soup_body({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}}));
  const Body other(soup_body({{{3, 0, 0}, {4, 0, 0}, {4, 0, 0}}}));
  expect_exactly(sweep(edge, {}, {4, 0, 0}, other), 0.5);
  // A point that meets a long flat box at the middle of its way.
  const Body box(box_body({640, 188, -0.5}, {1129, 189, 0.5}));
  expect_exactly(sweep(point_shape({}), {380, 241, 0}, {624, -104, 0}, box), 0.5);
  // A turn within a plane.
  const Shape blade(soup_body({{{1, 0, 0}, {3, 0, 0}, {3, 0.01, 0}}}));
  const Body target(soup_body({{{0, 2, 0}, {0.1, 2.5, 0}, {-0.1, 2.5, 0}}}));
  const RigidMotion turn = RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 3);
  const FirstContact found = first_contact(blade, turn, target);
  EXPECT_NE(found.verdict, ContactVerdict::free);
  const FirstContact twin = reference::first_contact_by_brute_force(blade, turn, target);
  EXPECT_LE(found.t.lower, twin.t.upper);
}

TEST(MotionRegressions, R69AStepOfAHundredLengthsTakesFewTests) {
  const Shape beam(box_body({-5, -0.5, -0.5}, {5, 0.5, 0.5}, 4));
  const Body other(box_body({-0.5, -5, -0.5}, {0.5, 5, 0.5}, 4));
  const test::AllocationWatch watch;
  const FirstContact hit = sweep(beam, {-500, 0.1, 0.2}, {1000, 0, 0}, other);
  EXPECT_EQ(hit.verdict, ContactVerdict::contact);
  EXPECT_LT(hit.cost.node_tests + hit.cost.triangle_tests, 20'000U);
  const FirstContact turning = first_contact(
      beam, RigidMotion::between(Pose::translation(-500, 7, 0), Pose::about_z(3, {500, 7, 0})),
      other);
  EXPECT_EQ(turning.coverage, Coverage::complete);
  EXPECT_LT(turning.cost.node_tests + turning.cost.triangle_tests, 200'000U);
  EXPECT_LT(watch.peak(), std::uint64_t{8} << 20);
}

TEST(MotionRegressions, R106EveryRuleAndLayoutGivesOneTime) {
  const Mesh rod = box_body({0, -0.02, -0.02}, {2, 0.02, 0.02}, 3);
  const Body wall(box_body({-1, 1.5, -1}, {3, 1.6, 1}, 3));
  const RigidMotion turn = RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 2.5);
  const FirstContact expected = first_contact(Shape(rod), turn, wall);
  ASSERT_EQ(expected.verdict, ContactVerdict::contact);
  for (const RuleEntry& rule : rules()) {
    for (const Layout layout : {Layout::wide, Layout::compact}) {
      const ShapeOptions options{.build = {.rule = rule.rule}, .layout = layout};
      const FirstContact found =
          first_contact(Shape(rod, options), turn, Body(Shape(wall.shape.shared_mesh(), options)));
      EXPECT_EQ(found.verdict, expected.verdict) << rule.name;
      // Each bracket holds the one time.
      EXPECT_LE(found.t.lower, expected.t.upper) << rule.name;
      EXPECT_GE(found.t.upper, expected.t.lower) << rule.name;
      EXPECT_NEAR(found.t.upper, expected.t.upper, 1e-11) << rule.name;
    }
  }
}

TEST(MotionRegressions, R107AHundredThousandStepsOfAPathAreAnswered) {
  constexpr std::size_t kSteps = 100'000;
  const Shape box(box_body({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  const Body post(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const auto pose = [](std::size_t k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k) / kSteps;
    return Pose::about_z(angle, {2 * std::cos(angle), 2 * std::sin(angle), 0});
  };
  std::vector<RigidMotion> path;
  for (std::size_t k = 0; k < kSteps; ++k) {
    path.push_back(RigidMotion::between(pose(k), pose(k + 1)));
  }
  const FirstContactBatch found = first_contact(box, path, post);
  EXPECT_EQ(std::count(found.verdict.begin(), found.verdict.end(), ContactVerdict::free),
            static_cast<std::ptrdiff_t>(kSteps));
  EXPECT_EQ(found.coverage, std::vector<Coverage>(kSteps, Coverage::complete));
}

// dimforge/parry#405: a box on a plate goes along it, up to a step.
TEST(MotionRegressions, R110WhatStartsInContactSlidesToTheNextOne) {
  const Shape box(test::box_body({-0.5, -0.5, 0}, {0.5, 0.5, 1}));
  const Body plate(
      soup_body({{{-20, -20, 0}, {40, -20, 0}, {0, 40, 0}}, {{3, -5, -1}, {3, 5, -1}, {3, 0, 4}}}));
  const RigidMotion motion = RigidMotion::along(Pose(), {5, 0, 0});
  const FirstContact start = first_contact(box, motion, plate);
  EXPECT_EQ(start.verdict, ContactVerdict::started);
  EXPECT_EQ(start.triangles->b, 0U);
  const FirstContact next = first_contact(box, motion, plate, {.parting = true});
  EXPECT_EQ(next.verdict, ContactVerdict::started);
  EXPECT_EQ(next.t, (Bracket{0.5, 0.5}));
  EXPECT_EQ(next.triangles->b, 1U);
  const FirstContact back =
      first_contact(box, RigidMotion::along(Pose(), {-5, 0, 0}), plate, {.parting = true});
  EXPECT_EQ(back.t, (Bracket{1, std::numeric_limits<double>::infinity()}));
}

TEST(MotionRegressions, R111AClearanceNextToTheGapTakesFewTests) {
  const auto tetrahedron = [](double shift) {
    const Vec3 a{0, 0, shift};
    const Vec3 b{1, 0, 1 + shift};
    const Vec3 c{-1, 0.5, 1 + shift};
    const Vec3 d{0, -1, 1 + shift};
    return soup_body({{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}});
  };
  const Shape mover(tetrahedron(1e-6 * 1.001));
  const Body floor(soup_body({{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}}));
  for (const RigidMotion& motion : {RigidMotion::along(Pose(), {1, 0.5, 0}),
                                    RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 1)}) {
    const FirstContact found = first_contact(mover, motion, floor, {.within = 1e-6});
    EXPECT_EQ(found.verdict, ContactVerdict::free);
    EXPECT_LT(found.cost.node_tests + found.cost.triangle_tests, 1000U);
  }
}

}  // namespace
}  // namespace soms
