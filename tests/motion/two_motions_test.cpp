// First contacts of two bodies that both move: the bounds of relative_law.h, and answers.
#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/relative_law.h"
#include "soms/motion/first_contact.h"
#include "soms/motion/print_motion.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/motion/place_by_law.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace soms {
namespace {

using detail::RelativeLaw;
using test::box_body;
using test::Far3;
using test::place_by_law;

Vec3 any_vector(Rng& rng, double most) {
  return {rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
}

/// A motion about a place; every third is a shift, every third turns nothing.
RigidMotion any_motion(Rng& rng, const Vec3& place, double step, double angle) {
  const Pose start = Pose::from_axis_angle(any_vector(rng, 1) + Vec3{0, 0, 2}, rng.uniform(-3, 3),
                                           place + any_vector(rng, step));
  const auto kind = rng.below(3);
  if (kind == 0) {
    return RigidMotion::along(start, any_vector(rng, step));
  }
  Pose end = start;
  if (kind == 1) {
    end = Pose::from_axis_angle(any_vector(rng, 1) + Vec3{0, 2, 0}, rng.uniform(-angle, angle)) *
          start;
  }
  const Vec3 to = start.shift() + any_vector(rng, step);
  for (std::size_t row = 0; row < 3; ++row) {
    end.m[4 * row + 3] = to[row];
  }
  return RigidMotion::between(start, end, any_vector(rng, 2));
}

/// Two motions near each other, far from the origin or not.
struct TwoMotions {
  Shape a{box_body({-1, -2, -1}, {2, 1, 3})};
  Shape b{box_body({-1, -1, -2}, {1, 2, 1})};
  RigidMotion of_a;
  RigidMotion of_b;

  explicit TwoMotions(Rng& rng) {
    constexpr std::array kFarOff{0.0, 1e3, 1e7};
    constexpr std::array kAngles{3.0, 1.0, 1e-3};
    const Vec3 place = any_vector(rng, kFarOff[rng.below(3)]);
    const double angle = kAngles[rng.below(3)];
    of_a = any_motion(rng, place, 6, angle);
    of_b = any_motion(rng, place, 6, angle);
  }
};

/// A point of the frame of the law, in world, by long doubles.
Far3 place_of_frame(const RigidMotion& b, bool turns, const Vec3& y, long double t) {
  if (turns) {
    return place_by_law(b, y, t);
  }
  const Far3 first = place_by_law(b, {}, 0);
  const Far3 now = place_by_law(b, {}, t);
  return {y.x + (now[0] - first[0]), y.y + (now[1] - first[1]), y.z + (now[2] - first[2])};
}

double apart(const Far3& a, const Far3& b) {
  return static_cast<double>(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
}

TEST(RelativeLaw, PlacesAndChordsAreWithinTheirBounds) {
  double greatest_share = 0;
  test::for_each_case("relative-law/chord", 1000, [&](Rng& rng) {
    const TwoMotions two(rng);
    const RelativeLaw law(two.a, two.of_a, two.b, two.of_b);
    const detail::MotionBounds bounds(law, two.b, 0);
    const bool turns = two.of_b.from() != two.of_b.to();
    const double from = rng.below(2) == 0 ? 0 : rng.uniform(0, 0.9);
    const double to = rng.below(2) == 0 ? 1 : rng.uniform(from, 1);
    const detail::MotionInterval interval(bounds, from, to);
    for (const Vec3& v : two.a.mesh().vertices) {
      const double t = rng.unit();
      ASSERT_LE(apart(place_by_law(two.of_a, v, t),
                      place_of_frame(two.of_b, turns, law.at(t).apply(v), t)),
                law.slack());
      const double bound = interval.bow.of(law.arm(v)) + 2 * law.slack();
      const double s = rng.uniform(-1, 1);
      const Vec3 chord = detail::mapped(interval.mean, v) + detail::mapped(interval.change, v) * s;
      const long double at = interval.middle + s * interval.half;
      const double off =
          apart(place_by_law(two.of_a, v, at), place_of_frame(two.of_b, turns, chord, at));
      ASSERT_LE(off, bound);
      greatest_share = std::max(greatest_share, off / bound);
    }
  });
  EXPECT_GT(greatest_share, 0.3);
}

TEST(RelativeLaw, VelocitiesAreThoseOfTheCurves) {
  test::for_each_case("relative-law/twist", 300, [](Rng& rng) {
    const TwoMotions two(rng);
    const RelativeLaw law(two.a, two.of_a, two.b, two.of_b);
    const double t = rng.uniform(0.01, 0.99);
    const detail::Twist twist = law.twist_at(t);
    for (const Vec3& v : two.a.mesh().vertices) {
      const Vec3 here = law.at(t).apply(v);
      const Vec3 step = law.at(t + 0x1p-13).apply(v) - law.at(t - 0x1p-13).apply(v);
      const Vec3 speed = twist.drift + cross(twist.spin, here - twist.pivot);
      ASSERT_LE(
          apart({speed.x, speed.y, speed.z}, {step.x * 0x1p12, step.y * 0x1p12, step.z * 0x1p12}),
          1e-3 * (1 + law.reach() * 1e-8));
    }
  });
}

// Samples between find no contact before one is said, and the pair touches when it is said.
void expect_holds(const TwoMotions& two, double within) {
  const FirstContact found = first_contact(two.a, two.of_a, two.b, two.of_b, {.within = within});
  const auto near_at = [&](double t) {
    return soms::within(Body(two.a, two.of_a.pose_at(t)), Body(two.b, two.of_b.pose_at(t)), within)
        .within;
  };
  ASSERT_NE(found.verdict, ContactVerdict::grazing);
  ASSERT_EQ(found.verdict == ContactVerdict::started, near_at(0));
  if (found.verdict != ContactVerdict::free) {
    ASSERT_TRUE(near_at(found.t.upper));
  }
  for (int k = 0; k <= 40; ++k) {
    const double t = std::min(1.0, found.t.lower) * k / 40;
    if (t < found.t.lower || found.verdict == ContactVerdict::free) {
      ASSERT_FALSE(near_at(t)) << t << ' ' << found.t;
    }
  }
}

TEST(TwoMotions, NoSampleIsInContactBeforeTheFirstOne) {
  test::for_each_case("two-motions/samples", 400, [](Rng& rng) {
    const TwoMotions two(rng);
    expect_holds(two, 0);
    expect_holds(two, 0.5);
  });
}

// A power of two changes no verdict, down to where squares of all numbers are 0.
TEST(TwoMotions, TheUnitDoesNotMatter) {
  const auto scaled = [](const Mesh& mesh, double unit) {
    return Shape(test::mapped(mesh, [&](const Vec3& v) { return v * unit; }));
  };
  const auto pose = [](const Pose& given, double unit) {
    Pose made = given;
    for (const std::size_t k : {3U, 7U, 11U}) {
      made.m[k] *= unit;
    }
    return made;
  };
  const Mesh x = test::soup_body({{{-2, 2, 2}, {-2, 2, -1}, {2, 0, 1}}});
  const Mesh y = test::soup_body({{{0, -2, 2}, {-1, -1, -2}, {2, -2, -2}}});
  const Pose from = Pose::translation(-2, -3, 3);
  const Pose to = Pose::from_quaternion(0.5, 0.5, 0.5, 0.5, {-2, 1, -1});
  for (const int exponent : {0, 200, -400, -560, -900}) {
    const double unit = std::ldexp(1.0, exponent);
    const RigidMotion motion = RigidMotion::between(pose(from, unit), pose(to, unit));
    const Shape fixed = scaled(y, unit);
    EXPECT_EQ(first_contact(scaled(x, unit), motion, Body(fixed), {.within = 0.125 * unit}).verdict,
              ContactVerdict::free)
        << exponent;
    EXPECT_EQ(first_contact(scaled(x, unit), motion, fixed,
                            RigidMotion::between(Pose(), Pose::about_z(1e-13)))
                  .verdict,
              ContactVerdict::free)
        << exponent;
  }
}

// Each is where the other was; nowhere near at both ends.
TEST(TwoMotions, TwoBodiesThatSwapPlacesMeet) {
  const Shape box(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const Pose left = Pose::translation(-5, 0, 0);
  const Pose right = Pose::translation(5, 0.25, 0);
  const FirstContact found =
      first_contact(box, RigidMotion::between(left, right), box, RigidMotion::between(right, left));
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_NEAR(found.t.lower, 0.45, 1e-12);
  EXPECT_NEAR(found.t.upper, 0.45, 1e-12);
  EXPECT_NEAR(found.point.x, 0, 1e-10);
  const FirstContact beside =
      first_contact(box, RigidMotion::between(left, Pose::translation(5, 1.125, 0)), box,
                    RigidMotion::between(Pose::translation(5, 1.125, 0), left));
  EXPECT_EQ(beside.verdict, ContactVerdict::contact);
  const FirstContact past = first_contact(
      box, RigidMotion::between(left, Pose::translation(5, 0, 0)), box,
      RigidMotion::between(Pose::translation(5, 1.125, 0), Pose::translation(-5, 1.125, 0)));
  EXPECT_EQ(past.verdict, ContactVerdict::free);
}

// A body beside another that turns with it keeps its distance, however long the way.
TEST(TwoMotions, WhatMovesTogetherKeepsItsDistance) {
  const Shape box(box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
  const Pose turn = Pose::about_z(2, {30, 4, 0});
  const Pose beside = Pose::translation(1.001, 0, 0);
  const FirstContact found =
      first_contact(box, RigidMotion::between({}, turn), box,
                    RigidMotion::between(beside, turn * beside, {-1.001, 0, 0}));
  EXPECT_EQ(found.verdict, ContactVerdict::free);
}

// The same question the other way round, and beside one that rests.
TEST(TwoMotions, EitherBodyMayBeTheMover) {
  test::for_each_case("two-motions/sides", 100, [](Rng& rng) {
    const TwoMotions two(rng);
    const FirstContact there = first_contact(two.a, two.of_a, two.b, two.of_b);
    const FirstContact back = first_contact(two.b, two.of_b, two.a, two.of_a);
    ASSERT_EQ(there.verdict, back.verdict);
    ASSERT_LE(there.t.lower, back.t.upper);
    ASSERT_LE(back.t.lower, there.t.upper);
    const Pose still = two.of_b.start();
    const FirstContact alone = first_contact(two.a, two.of_a, Body(two.b, still));
    const FirstContact resting =
        first_contact(two.a, two.of_a, two.b, RigidMotion::between(still, still));
    ASSERT_EQ(alone.verdict, resting.verdict);
    // A shift that is decided in whole numbers has a bracket of no width.
    ASSERT_LE(alone.t.lower, resting.t.upper + 1e-7);
    ASSERT_LE(resting.t.lower, alone.t.upper + 1e-7);
  });
}

}  // namespace
}  // namespace soms
