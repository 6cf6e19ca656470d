#include "apps/draw/eye.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms::look {
namespace {

TEST(Eye, APageHasXToTheRightAndYDownward) {
  const CameraFrame north = frame_along({0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(north.on_page({3, 5, 2}), (Vec3{3, -2, 5}));
}

TEST(Eye, LooksAlongTheVerticalAsAPlan) {
  const CameraFrame plan = frame_along({0, 0, -1}, {0, 0, 1});
  EXPECT_EQ(plan.right, (Vec3{1, 0, 0}));
  EXPECT_EQ(plan.up, (Vec3{0, 1, 0}));
}

TEST(Eye, PlacesWhatItSees) {
  const Eye eye{{0, -10, 0}, frame_along({0, 1, 0}, {0, 0, 1}), 0.5};
  const auto place = [&](const Vec3& point) { return eye.place(eye.see(point), 200, 100); };
  EXPECT_EQ(place({0, 0, 0}), (Vec3{100, 50, -0.1}));
  EXPECT_EQ(place({0, 0, 5}), (Vec3{100, 0, -0.1})) << "the upper edge";
  EXPECT_EQ(place({10, 0, -5}), (Vec3{200, 100, -0.1})) << "the lower right corner";
  // Depths order points, and on a line they are linear in the picture.
  const Vec3 near = place({-2, -4, 1});
  const Vec3 far = place({4, 6, -3});
  const Vec3 between = place({1, 1, -1});
  EXPECT_LT(near.z, far.z);
  const double share = (between.x - near.x) / (far.x - near.x);
  EXPECT_NEAR(between.y, near.y + share * (far.y - near.y), 1e-12);
  EXPECT_NEAR(between.z, near.z + share * (far.z - near.z), 1e-15);
}

TEST(Eye, LightsTheTopMostAndBothSidesAlike) {
  const Vec3 sight{-0.4, 0.8, -std::sqrt(0.2)};  // from before, above and the right
  const CameraFrame frame = frame_along(sight, {0, 0, 1});
  const auto light = [&](const Vec3& normal) {
    return brightness(frame, normal, frame.forward, 0.4);
  };
  EXPECT_GT(light({0, 0, 1}), light({0, -1, 0}));
  EXPECT_GT(light({0, -1, 0}), light({1, 0, 0})) << "the right side is in the shade";
  EXPECT_EQ(light({0, 0, 5}), light({0, 0, -1}));
  EXPECT_EQ(light({1, 0, 0}), 0.4);
  EXPECT_EQ(light({}), 1);
}

}  // namespace
}  // namespace soms::look
