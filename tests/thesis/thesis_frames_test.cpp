#include "soms/thesis/thesis_frames.h"

#include "tests/support/host_arithmetic.h"

#include <gtest/gtest.h>

namespace soms {
namespace {

constexpr Box kStill{{1, 2, 3}, {3, 6, 11}};

Box moved(const Vec3& by) {
  return {kStill.lower + by, kStill.upper + by};
}

TEST(OrientationTests, ComeFromTheirSideTouchAndEndHalfInside) {
  for (const auto& [from, name] : kAllApproaches) {
    const auto offsets = orientation_test(kStill, from);
    ASSERT_EQ(offsets.size(), 49U) << name;
    EXPECT_FALSE(overlaps(kStill, moved(offsets[31]))) << name;
    EXPECT_TRUE(overlaps(kStill, moved(offsets[32]))) << name;
  }
  EXPECT_EQ(orientation_test(kStill, Approach::right)[0], (Vec3{4, 0, 0}));
  EXPECT_EQ(orientation_test(kStill, Approach::left)[32], (Vec3{-2, 0, 0}));
  EXPECT_EQ(orientation_test(kStill, Approach::top)[48], (Vec3{0, 2, 0}));
  EXPECT_EQ(orientation_test(kStill, Approach::bottom)[48], (Vec3{0, -2, 0}));
  EXPECT_EQ(orientation_test(kStill, Approach::top, 2)[32], (Vec3{0, 0, 8}));
  EXPECT_EQ(orientation_test(kStill, Approach::front)[0], (Vec3{0, 0, 16}));
  EXPECT_EQ(orientation_test(kStill, Approach::back)[48], (Vec3{0, 0, -4}));
  EXPECT_EQ(orientation_test(kStill, Approach::front, 2)[32], (Vec3{0, -4, 0}));
}

TEST(OrientationTests, ComeFromOppositeSidesAlongEachAxis) {
  for (const std::size_t up : {1U, 2U}) {
    for (std::size_t i = 0; i < kAllApproaches.size(); i += 2) {
      const ApproachLine one = approach_line(kAllApproaches[i].first, up);
      const ApproachLine other = approach_line(kAllApproaches[i + 1].first, up);
      EXPECT_EQ(one, (ApproachLine{other.axis, -other.side}));
    }
  }
  EXPECT_EQ(approach_line(Approach::front, 1), (ApproachLine{2, 1}));
  EXPECT_EQ(approach_line(Approach::top, 2), (ApproachLine{2, 1}));
}

// As `transformed` turns y up to z up: (x, y, z) becomes (x, -z, y).
TEST(OrientationTests, TurnWithTheObject) {
  for (const auto& [from, name] : kAllApproaches) {
    const ApproachLine line = approach_line(from, 1);
    Vec3 direction;
    direction[line.axis] = line.side;
    const Vec3 turned{direction.x, -direction.z, direction.y};
    const ApproachLine turned_line = approach_line(from, 2);
    EXPECT_EQ(turned[turned_line.axis], turned_line.side) << name;
  }
}

TEST(OrientationTests, AreTheSameWhateverTheHostRounds) {
  constexpr Box kUneven{{0.1, 0.2, 0.3}, {0.8, 1.9, 3.7}};
  for (const auto& [from, name] : kAllApproaches) {
    const auto plain = orientation_test(kUneven, from);
    for (const test::HostMode& mode : test::host_modes()) {
      const test::HostArithmetic host(mode);
      EXPECT_EQ(orientation_test(kUneven, from), plain) << name << ", " << mode.name;
    }
  }
}

TEST(OrientationTests, BringOtherObjectsToTheMiddle) {
  constexpr Box kOther{{10, 10, 10}, {11, 12, 14}};
  for (const auto& [from, name] : kAllApproaches) {
    const auto alone = orientation_test(kStill, from, 2);
    EXPECT_EQ(orientation_test(kStill, kStill, from, 2), alone) << name;
    const auto offsets = orientation_test(kStill, kOther, from, 2);
    ASSERT_EQ(offsets.size(), alone.size());
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      EXPECT_EQ(kOther.center() + offsets[k], kStill.center() + alone[k]) << name << ", " << k;
    }
  }
}

TEST(DriveThrough, GoesFromEndToEndThroughTheMiddle) {
  constexpr Box kScene{{0, 0, 0}, {100, 40, 10}};
  constexpr Box kShort{{0, 0, 0}, {2, 2, 2}};
  constexpr Box kLong{{0, 0, 0}, {60, 2, 2}};
  const auto offsets = drive_through(kScene, kShort);
  ASSERT_EQ(offsets.size(), 221U);
  EXPECT_EQ(offsets.front(), (Vec3{-6, 19, -0.1}));
  EXPECT_EQ(offsets[110], (Vec3{49, 19, -0.1}));
  EXPECT_EQ(offsets.back(), (Vec3{104, 19, -0.1}));
  EXPECT_EQ(drive_through(kScene, kLong).front(), (Vec3{-90, 19, -0.1}));
  const auto with_y_up = drive_through(kScene, kShort, 1);
  EXPECT_EQ(with_y_up.front(), (Vec3{-6, -0.4, 4}));
}

TEST(CityDrive, GoesAlongTheMiddleOfTheCity) {
  const auto offsets = city_drive();
  ASSERT_EQ(offsets.size(), 221U);
  EXPECT_EQ(offsets.front(), (Vec3{-200, 2000, -16}));
  EXPECT_EQ(offsets.back(), (Vec3{4200, 2000, -16}));
}

}  // namespace
}  // namespace soms
