#include "apps/view/scene/orientation_menu.h"

#include "soms/base/error.h"
#include "soms/thesis/thesis_frames.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

constexpr Box kStill{{-1, 0, 2}, {3, 2, 8}};
constexpr Box kCar{{0, 0, 0}, {1, 1, 1}};

TEST(OrientationMenu, GivesTheThesisOffsetsForEqualModels) {
  for (const auto& [approach, name] : kAllApproaches) {
    for (const std::size_t up : {1U, 2U}) {
      const std::vector<Vec3> offsets = orientation_test(kStill, approach, up);
      const std::vector<Pose> poses = orientation_poses(name, kStill, kStill, up);
      ASSERT_EQ(poses.size(), offsets.size());
      for (std::size_t k = 0; k < poses.size(); ++k) {
        EXPECT_EQ(poses[k].shift(), offsets[k]);
      }
    }
  }
}

TEST(OrientationMenu, BringsOtherModelsToTheMiddle) {
  const std::vector<Pose> poses = orientation_poses("top", kStill, kCar, 2);
  const Vec3 middle = kCar.center() + poses.back().shift();
  EXPECT_EQ(middle.x, kStill.center().x);
  EXPECT_EQ(middle.y, kStill.center().y);
  EXPECT_GT(middle.z, kStill.center().z);
}

TEST(OrientationMenu, DrivesThroughFromEndToEnd) {
  const std::vector<Pose> poses = orientation_poses("drive", kStill, kCar, 2);
  ASSERT_EQ(poses.size(), 221U);
  EXPECT_LT(kCar.center().x + poses.front().shift().x, kStill.lower.x);
  EXPECT_GT(kCar.center().x + poses.back().shift().x, kStill.upper.x);
  EXPECT_LT(poses[0].shift().z, kStill.lower.z);
}

TEST(OrientationMenu, ListsWhatItOffers) {
  for (const OrientationTest& test : orientation_tests()) {
    EXPECT_FALSE(orientation_poses(test.name, kStill, kCar, 2).empty());
    EXPECT_FALSE(test.title.empty());
    EXPECT_FALSE(test.description.empty());
  }
  EXPECT_EQ(orientation_tests().size(), 7U);
}

TEST(OrientationMenu, KnowsHowLongTestsAreAndWhereTheyTouchMost) {
  for (const OrientationTest& test : orientation_tests()) {
    const std::vector<Pose> poses = orientation_poses(test.name, kStill, kCar, 2);
    EXPECT_EQ(frame_count(test.name), poses.size()) << test.name;
    const std::size_t fullest = fullest_frame(test.name);
    ASSERT_LT(fullest, poses.size()) << test.name;
    // No frame brings the middles nearer to each other.
    const auto apart = [&](std::size_t k) {
      const Vec3 by = kCar.center() + poses[k].shift() - kStill.center();
      return dot(by, by);
    };
    for (std::size_t k = 0; k < poses.size(); ++k) {
      EXPECT_GE(apart(k), apart(fullest) * (1 - 1e-12)) << test.name << ' ' << k;
    }
    EXPECT_EQ(orientation_tests()[orientation_row(test.name)].name, test.name);
  }
}

TEST(OrientationMenu, RefusesOtherNames) {
  EXPECT_THROW((void)orientation_poses("inside", kStill, kCar, 2), Error);
  EXPECT_THROW((void)orientation_row("inside"), Error);
  EXPECT_THROW((void)fullest_frame("inside"), Error);
}

}  // namespace
}  // namespace soms::view
