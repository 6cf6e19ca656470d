// The twin of first contacts: times that are known from elsewhere.
#include "soms/motion/reference/first_contact.h"

#include "soms/motion/reference/detail/dyadic.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms::reference {
namespace {

TEST(FirstContactTwin, KnowsTheTimeOfAShift) {
  const Shape mover(test::box_body({0, 0, 0}, {1, 1, 1}));
  const Body wall(test::box_body({3, 0.25, 0.25}, {4, 0.5, 0.5}));
  const FirstContact found =
      first_contact_by_brute_force(mover, RigidMotion::along(Pose(), {8, 0.01, 0.02}), wall);
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_NEAR(found.t.lower, 0.25, 1e-12);
  EXPECT_NEAR(found.t.upper, 0.25, 1e-12);
  EXPECT_EQ(
      first_contact_by_brute_force(mover, RigidMotion::along(Pose(), {1.99, 0, 0}), wall).verdict,
      ContactVerdict::free);
}

// The corner (3, 4) turns to (0, 5) by an angle of acos(0.8), and meets a wall at y = 4.5 before.
TEST(FirstContactTwin, KnowsTheTimeOfATurn) {
  const Shape mover(test::soup_body({{{3, 4, 0}, {2, 3, -1}, {2, 3, 1}}}));
  const Body wall(test::soup_body({{{-9, 4.5, -9}, {9, 4.5, -9}, {0, 4.5, 9}}}));
  const double whole = std::acos(0.8);
  const RigidMotion motion = RigidMotion::turn(Pose(), {0, 0, 0}, {0, 0, 1}, whole);
  const double angle = std::asin(0.9) - std::asin(0.8);
  // tan of half the angle is t sin(whole / 2) / (1 - t + t cos(whole / 2)).
  const double slope = std::tan(angle / 2);
  const double t = slope / (std::sin(whole / 2) + slope * (1 - std::cos(whole / 2)));
  const FirstContact found = first_contact_by_brute_force(mover, motion, wall);
  ASSERT_EQ(found.verdict, ContactVerdict::contact);
  EXPECT_NEAR(found.t.lower, t, 1e-12);
  EXPECT_NEAR(found.t.upper, t, 1e-12);
}

TEST(FirstContactTwin, StartsWhereTheStartTouches) {
  const Shape mover(test::box_body({0, 0, 0}, {1, 1, 1}));
  const FirstContact found = first_contact_by_brute_force(
      mover, RigidMotion::along(Pose(), {-1, 0, 0}), Body(test::box_body({1, 0, 0}, {2, 1, 1})));
  EXPECT_EQ(found.verdict, ContactVerdict::started);
  EXPECT_EQ(found.t, (Bracket{0, 0}));
}

TEST(Cubic, IsPositiveWhereItsCoefficientsAre) {
  using detail::Cubic;
  using detail::Dyadic;
  const Cubic line(Dyadic(-1), Dyadic(4));  // 4 t - 1
  const Cubic square = line * line + Cubic(Dyadic(0x1p-30));
  EXPECT_EQ(line(Dyadic(0.25)).sign(), 0);
  EXPECT_EQ(line(Dyadic(0.5)).sign(), 1);
  EXPECT_TRUE(line.positive_on(Dyadic(0.25 + 0x1p-40), Dyadic(1)));
  EXPECT_FALSE(line.positive_on(Dyadic(0.25), Dyadic(1)));
  EXPECT_FALSE(line.positive_on(Dyadic(0), Dyadic(1)));
  EXPECT_EQ(square(Dyadic(0.25)).sign(), 1);
  EXPECT_TRUE(square.positive_on(Dyadic(0.25), Dyadic(0.25 + 0x1p-10)));
  EXPECT_FALSE(square.positive_on(Dyadic(0), Dyadic(1)));  // above 0, but no coefficients show it
}

}  // namespace
}  // namespace soms::reference
