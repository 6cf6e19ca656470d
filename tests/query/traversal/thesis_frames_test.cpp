#include "soms/query/traversal/thesis_frames.h"

#include <gtest/gtest.h>

namespace soms {
namespace {

constexpr Box kStill{{1, 2, 3}, {3, 6, 11}};

Box moved(const Vec3& by) {
  return {kStill.lower + by, kStill.upper + by};
}

TEST(OrientationTests, ComeFromTheirSideTouchAndEndHalfInside) {
  for (const auto& [from, name] : kApproaches) {
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
}

TEST(CityDrive, GoesAlongTheMiddleOfTheCity) {
  const auto offsets = city_drive();
  ASSERT_EQ(offsets.size(), 221U);
  EXPECT_EQ(offsets.front(), (Vec3{-200, 2000, -16}));
  EXPECT_EQ(offsets.back(), (Vec3{4200, 2000, -16}));
}

}  // namespace
}  // namespace soms
