// First contacts of bodies on their way: the cases that samples and straight corners get wrong.
#include "soms/motion/first_contact.h"

#include "soms/base/error.h"
#include "soms/base/stop_token.h"
#include "soms/motion/print_motion.h"
#include "soms/motion/reference/first_contact.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/within.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace soms {
namespace {

using test::box_body;

constexpr double kNoContact = std::numeric_limits<double>::infinity();

/// A contact proved at a time near `t`, with what it promises of its bracket.
void expect_contact(const FirstContact& found, const Shape& mover, const RigidMotion& motion,
                    const Body& fixed, double t, double most) {
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_EQ(found.coverage, Coverage::complete);
  EXPECT_LE(found.t.lower, found.t.upper);
  EXPECT_NEAR(found.t.lower, t, most);
  EXPECT_NEAR(found.t.upper, t, most);
  ASSERT_TRUE(found.triangles);
  if (!motion.straight()) {
    EXPECT_TRUE(overlap(Body(mover, motion.pose_at(found.t.upper)), fixed).any);
  }
}

FirstContact expect_free(const Shape& mover, const RigidMotion& motion, const Body& fixed) {
  FirstContact found = first_contact(mover, motion, fixed);
  EXPECT_EQ(found.verdict, ContactVerdict::free);
  EXPECT_EQ(found.t, (Bracket{1, kNoContact}));
  EXPECT_FALSE(found.triangles);
  EXPECT_FALSE(found.normal);
  EXPECT_EQ(found.coverage, Coverage::complete);
  return found;
}

TEST(FirstContact, AStepOfTenMetersDoesNotPassAThinWall) {
  const Shape mover(box_body({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}));
  const Body wall(box_body({5, -2, -2}, {5.001, 2, 2}));
  const RigidMotion motion = RigidMotion::along(Pose(), {10, 0, 0});
  const FirstContact found = first_contact(mover, motion, wall);
  expect_contact(found, mover, motion, wall, 0.49, 1e-15);
  EXPECT_LE(found.t.upper, std::nextafter(found.t.lower, 1));
  EXPECT_EQ(found.point.x, 5);
  expect_free(mover, RigidMotion::along(Pose::translation(0, 3, 0), {10, 0, 0}), wall);
}

// The blade lies along x at the start and along -x at the end, nowhere near the post at any of
// eleven equal times.
TEST(FirstContact, ARotatingBladeDoesNotPassAPost) {
  const Shape blade(box_body({0, -0.01, -0.01}, {2, 0.01, 0.01}));
  const double angle = 1.234;
  const Vec3 at{1.5 * std::cos(angle), 1.5 * std::sin(angle), 0};
  const Body post(box_body({at.x - 0.002, at.y - 0.002, -1}, {at.x + 0.002, at.y + 0.002, 1}));
  const RigidMotion motion = RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 3);
  for (int k = 0; k <= 10; ++k) {
    ASSERT_FALSE(overlap(Body(blade, motion.pose_at(0.1 * k)), post).any);
  }
  const FirstContact found = first_contact(blade, motion, post);
  const FirstContact twin = reference::first_contact_by_brute_force(blade, motion, post);
  ASSERT_EQ(twin.verdict, ContactVerdict::contact);
  expect_contact(found, blade, motion, post, twin.t.upper, 1e-12);
  EXPECT_LE(found.t.lower, twin.t.upper);
  // The far side of the way, past where the time is halved.
  const RigidMotion back = RigidMotion::turn(Pose::about_z(3), {0, 0, 0}, {0, 0, 1}, -3);
  const FirstContact late = first_contact(blade, back, post);
  expect_contact(late, blade, back, post,
                 reference::first_contact_by_brute_force(blade, back, post).t.upper, 1e-12);
  EXPECT_GT(late.t.lower, 0.5);
  expect_free(blade, motion, Body(post.shape, Pose::translation(0, 0, 1.02)));
}

// Corners move on circles, not on straight lines: a chord of this one stays 0.2 from the wall.
TEST(FirstContact, ACornersCircleIsTangentToAWall) {
  const Shape arm(box_body({0, -0.5, -0.5}, {4.8, 0.5, 0.5}));
  const double radius = std::hypot(4.8, 0.5);
  const RigidMotion motion = RigidMotion::turn(Pose::about_z(-0.6), {0, 0, 0}, {0, 0, 1}, 1.2);
  const auto wall = [&](double gap) {
    return Body(box_body({radius + gap, -9, -9}, {radius + gap + 1, 9, 9}));
  };
  expect_free(arm, motion, wall(1e-9));
  const FirstContact deep = first_contact(arm, motion, wall(-1e-9));
  const FirstContact twin = reference::first_contact_by_brute_force(arm, motion, wall(-1e-9));
  expect_contact(deep, arm, motion, wall(-1e-9), twin.t.upper, 1e-6);
  EXPECT_LE(deep.t.lower, twin.t.upper);
  // Touching but for rounding: whatever is said, it is not "free" where the law touches.
  const FirstContact kiss = first_contact(arm, motion, wall(0));
  EXPECT_NE(kiss.verdict, ContactVerdict::started);
  EXPECT_LE(kiss.t.lower, 0.5);
}

TEST(FirstContact, ALongArmSweepsFarBySmallAngles) {
  const Shape mover(box_body({1000, -0.5, -0.5}, {1001, 0.5, 0.5}));
  const RigidMotion motion = RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 0.01);
  const Body wall(box_body({999, 5, -1}, {1002, 5.001, 1}));
  const FirstContact found = first_contact(mover, motion, wall);
  const FirstContact twin = reference::first_contact_by_brute_force(mover, motion, wall);
  ASSERT_EQ(twin.verdict, ContactVerdict::contact);
  expect_contact(found, mover, motion, wall, twin.t.upper, 1e-9);
  // The arm ends 1.0015 beyond its chord's sagitta of 0.0125.
  expect_free(mover, motion, Body(box_body({1001.02, -9, -1}, {1002, 20, 1})));
}

TEST(FirstContact, AMotionOfNoLengthIsFreeOrStarts) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body beside(box_body({1.5, 0, 0}, {2, 1, 1}));
  const Body touching(box_body({1, 0.5, 0}, {2, 1, 1}));
  expect_free(mover, RigidMotion::along(Pose(), {0, 0, 0}), beside);
  expect_free(mover, RigidMotion(), beside);
  expect_free(mover, RigidMotion::between(Pose(), Pose()), beside);
  for (const RigidMotion& motion : {RigidMotion(), RigidMotion::along(Pose(), {-1, 0, 0}),
                                    RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, 1)}) {
    const FirstContact found = first_contact(mover, motion, touching);
    EXPECT_EQ(found.verdict, ContactVerdict::started);
    EXPECT_EQ(found.t, (Bracket{0, 0}));
    ASSERT_TRUE(found.triangles);
    EXPECT_FALSE(found.normal);
    EXPECT_EQ(found.point.x, 1);
  }
}

// Poses are rotations to 1e-6. The law turns by a rotation; the end is decided as it is.
TEST(FirstContact, AStretchedEndIsDecidedAsItIs) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  Pose end = Pose::translation(0.1, 0, 0);
  end.m[0] = 1 + 4e-7;
  const Body wall(box_body({1.1 + 2e-7, -1, -1}, {2, 2, 2}));
  const RigidMotion motion = RigidMotion::between(Pose(), end);
  ASSERT_TRUE(overlap(Body(mover, end), wall).any);
  ASSERT_FALSE(overlap(Body(mover, motion.law_at(1)), wall).any);
  const FirstContact found = first_contact(mover, motion, wall);
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_EQ(found.t.upper, 1);
  EXPECT_LT(found.t.lower, 1);
  ASSERT_TRUE(found.triangles);
  const RigidMotion back = RigidMotion::between(end, Pose());
  EXPECT_EQ(first_contact(mover, back, wall).verdict, ContactVerdict::started);
}

// All eight triangles of the lower and upper face touch at once; the least pair is named.
TEST(FirstContact, TiesOfAStraightMotionAreDecidedExactly) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}, 3));
  const Body floor(box_body({-1, -1, -2}, {2, 2, -1}, 2));
  const RigidMotion motion = RigidMotion::along(Pose(), {0, 0, -3});
  const FirstContact found = first_contact(mover, motion, floor);
  expect_contact(found, mover, motion, floor, 1.0 / 3, 1e-15);
  EXPECT_LT(found.t.lower, 1.0L / 3);
  EXPECT_GT(found.t.upper, 1.0L / 3);
  TrianglePair least{0xffffffffU, 0};
  for (const TrianglePair& pair : overlap(Body(mover, Pose::translation(0, 0, -1)), floor).pairs) {
    least = std::min(least, pair);
  }
  EXPECT_EQ(*found.triangles, least);
  EXPECT_FALSE(found.normal);  // faces on faces
  for (const Layout layout : {Layout::wide, Layout::compact}) {
    const Shape other(box_body({0, 0, 0}, {1, 1, 1}, 3),
                      {.build = {.rule = Rule::spatial_median}, .layout = layout});
    const FirstContact again = first_contact(other, motion, floor);
    EXPECT_EQ(again.t, found.t);
    EXPECT_EQ(again.triangles, found.triangles);
  }
}

// A box on a plate of one triangle slides to a step; without the option it only starts.
TEST(FirstContact, WhatRestsOnAPlateSlidesToAStep) {
  const Shape box(box_body({0, 0, 0}, {1, 1, 1}));
  const Mesh plate = test::soup_body(
      {{{-19, -9, 0}, {29, -9, 0}, {0, 29, 0}}, {{4, -9, 0}, {4, 9, 0}, {4, 0, 2}}});
  const Body floor{plate};
  const FirstContactOptions parting{.parting = true};
  for (const RigidMotion& motion : {RigidMotion::along(Pose(), {6, 0, 0}),
                                    RigidMotion::between(Pose(), Pose::translation(6, 0, 0))}) {
    EXPECT_EQ(first_contact(box, motion, floor).t, (Bracket{0, 0}));
    const FirstContact found = first_contact(box, motion, floor, parting);
    EXPECT_EQ(found.verdict, ContactVerdict::started);
    EXPECT_NEAR(found.t.lower, 0.5, 1e-12);
    EXPECT_NEAR(found.t.upper, 0.5, 1e-12);
    ASSERT_TRUE(found.triangles);
    EXPECT_EQ(found.triangles->b, 1U);
  }
  for (const RigidMotion& motion :
       {RigidMotion::along(Pose(), {2, 0, 0}), RigidMotion::along(Pose(), {1, 0, 3}),
        RigidMotion::turn(Pose(), {0.5, 0.5, 0}, {0, 0, 1}, 1)}) {
    const FirstContact found = first_contact(box, motion, floor, parting);
    EXPECT_EQ(found.verdict, ContactVerdict::started);
    EXPECT_EQ(found.t, (Bracket{1, kNoContact}));
    EXPECT_FALSE(found.triangles);
  }
  EXPECT_EQ(
      first_contact(box, RigidMotion::along(Pose::translation(0, 0, 1), {0, 0, 1}), floor, parting)
          .verdict,
      ContactVerdict::free);
  EXPECT_THROW(
      static_cast<void>(first_contact(box, RigidMotion(), floor, {.within = 1, .parting = true})),
      Error);
}

// With `parting`, the least of all pairs that do not touch at the start.
TEST(FirstContact, PartingLeavesOutWhatTouchesAtTheStart) {
  test::for_each_case("first-contact/parting", 60, [](Rng& rng) {
    const auto any = [&](double most) {
      return Vec3{rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
    };
    const auto soup = [&] {
      std::vector<Triangle> triangles;
      for (int k = 0; k < 5; ++k) {
        const Vec3 at = any(1.5);
        triangles.push_back({at + any(1), at + any(1), at + any(1)});
      }
      return triangles;
    };
    const std::vector<Triangle> a = soup();
    const std::vector<Triangle> b = soup();
    const RigidMotion motion =
        rng.below(2) == 0
            ? RigidMotion::along(Pose(), any(3))
            : RigidMotion::between(Pose(), Pose::from_axis_angle(any(1), 1, any(2)), any(1));
    double lower = kNoContact;
    double upper = kNoContact;
    bool started = false;
    for (const Triangle& x : a) {
      for (const Triangle& y : b) {
        const FirstContact one = reference::first_contact_by_brute_force(
            Shape(test::soup_body({x})), motion, Body(Shape(test::soup_body({y}))));
        if (one.verdict == ContactVerdict::started) {
          started = true;
        } else {
          lower = std::min(lower, one.t.lower);
          upper = std::min(upper, one.t.upper);
        }
      }
    }
    const FirstContact found = first_contact(Shape(test::soup_body(a)), motion,
                                             Body(Shape(test::soup_body(b))), {.parting = true});
    ASSERT_EQ(found.verdict == ContactVerdict::started, started);
    ASSERT_EQ(found.t.upper == kNoContact, upper == kNoContact);
    ASSERT_LE(found.t.lower, upper);
    ASSERT_LE(lower, found.t.upper);
  });
}

TEST(FirstContact, TheEndOfAStraightMotionBelongsToIt) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body wall(box_body({3, -1, -1}, {4, 2, 2}));
  const FirstContact found = first_contact(mover, RigidMotion::along(Pose(), {2, 0, 0}), wall);
  EXPECT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_EQ(found.t, (Bracket{1, 1}));
  expect_free(mover, RigidMotion::along(Pose(), {std::nextafter(2.0, 0.0), 0, 0}), wall);
}

TEST(FirstContact, NamesTheNormalOfACornerOnAFaceAndOfEdgesThatCross) {
  const Shape corner(test::soup_body({{{0, 0, 0}, {1, 0.1, 2}, {-1, 0.3, 2}}}));
  const Body floor(test::soup_body({{{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}}}));
  for (const RigidMotion& motion :
       {RigidMotion::along(Pose(), {0.25, 0.125, -2}),
        RigidMotion::between(Pose(), Pose::about_z(0.7, {0.25, 0.125, -2}))}) {
    const FirstContact found = first_contact(corner, motion, floor);
    ASSERT_EQ(found.verdict, ContactVerdict::contact);
    ASSERT_TRUE(found.normal);
    EXPECT_NEAR(found.normal->z, 1, 1e-9);
    EXPECT_NEAR(found.point.z, -1, 1e-9);
    EXPECT_NEAR(found.point.x, 0.125, 0.01);
  }
  const Shape edge(test::soup_body({{{-1, 0, 0}, {1, 0, 0}, {0, 0, 3}}}));
  const Body other(test::soup_body({{{0.25, -1, -1}, {0.25, 1, -1}, {0.25, 0, -4}}}));
  const FirstContact crossing =
      first_contact(edge, RigidMotion::along(Pose(), {0, 0.125, -3}), other);
  ASSERT_EQ(crossing.verdict, ContactVerdict::contact);
  ASSERT_TRUE(crossing.normal);
  EXPECT_NEAR(crossing.normal->z, 1, 1e-12);
}

TEST(FirstContact, AClearanceIsMetEarlier) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body post(box_body({5, 0.4, -3}, {6, 0.6, 3}));
  const RigidMotion shift = RigidMotion::along(Pose(), {8, 0, 0});
  const FirstContact near = first_contact(mover, shift, post, {.within = 0.5});
  ASSERT_EQ(near.verdict, ContactVerdict::contact);
  EXPECT_NEAR(near.t.upper, 3.5 / 8, 1e-12);
  EXPECT_TRUE(within(Body(mover, shift.pose_at(near.t.upper)), post, 0.5).within);
  EXPECT_FALSE(within(Body(mover, shift.pose_at(near.t.lower - 1e-9)), post, 0.5).within);
  const RigidMotion turn = RigidMotion::turn(Pose(), {0, -5, 0}, {0, 0, 1}, -1.5);
  const Body beside(box_body({4, -1.6, -3}, {4.2, -1.4, 3}));
  for (const double clearance : {0.0, 0.125, 1.0}) {
    const FirstContact found = first_contact(mover, turn, beside, {.within = clearance});
    ASSERT_EQ(found.verdict, ContactVerdict::contact) << clearance;
    ASSERT_TRUE(within(Body(mover, turn.pose_at(found.t.upper)), beside, clearance).within);
    ASSERT_NEAR(distance(Body(mover, turn.pose_at(found.t.lower)), beside).distance.lower,
                clearance, 1e-9);
    ASSERT_LE(found.t.upper - found.t.lower, 1e-9);
  }
  EXPECT_EQ(first_contact(mover, shift, post, {.within = 4}).verdict, ContactVerdict::started);
  EXPECT_EQ(first_contact(mover, shift, post, {.within = kNoContact}).verdict,
            ContactVerdict::started);
  const Body far(box_body({0, 3, 0}, {1, 4, 1}));
  EXPECT_EQ(first_contact(mover, shift, far, {.within = 1.999}).verdict, ContactVerdict::free);
}

TEST(FirstContact, OfNothingIsFree) {
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  expect_free(mover, RigidMotion::along(Pose(), {9, 0, 0}), Body());
  expect_free(Shape(), RigidMotion::along(Pose(), {9, 0, 0}), Body(mover));
}

TEST(FirstContact, RefusesWhatIsNoQuestion) {
  const auto kind_of = [](const auto& ask) {
    try {
      static_cast<void>(ask());
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  const Shape mover(box_body({0, 0, 0}, {1, 1, 1}));
  const Body fixed(box_body({3, 0, 0}, {4, 1, 1}));
  Pose bad;
  bad.m[0] = 3;
  EXPECT_EQ(kind_of([&] { return first_contact(mover, RigidMotion(), Body(mover, bad)); }),
            ErrorKind::not_rigid);
  EXPECT_EQ(kind_of([&] { return first_contact(mover, RigidMotion(), fixed, {.within = -1}); }),
            ErrorKind::usage);
  EXPECT_EQ(
      kind_of([&] { return first_contact(mover, RigidMotion(), fixed, {.within = std::nan("")}); }),
      ErrorKind::usage);
  EXPECT_EQ(kind_of([&] {
              return first_contact(mover, RigidMotion::along(Pose(), {0x1p301, 0, 0}), fixed);
            }),
            ErrorKind::out_of_range);
  StopSource stop;
  stop.request_stop();
  EXPECT_EQ(kind_of([&] {
              return first_contact(mover, RigidMotion(), fixed, {}, {.stop = stop.get_token()});
            }),
            ErrorKind::cancelled);
}

TEST(FirstContact, IsPrinted) {
  std::ostringstream out;
  out << FirstContact{};
  EXPECT_EQ(out.str().substr(0, 37), "FirstContact{verdict: free, t: Bracke");
}

}  // namespace
}  // namespace soms
