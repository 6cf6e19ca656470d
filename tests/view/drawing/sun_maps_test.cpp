#include "apps/view/drawing/sun_maps.h"

#include <gtest/gtest.h>

#include <array>

namespace soms::view {
namespace {

std::array<double, 3> placed(const SunMap& map, const GlView& view, const Vec3& p) {
  const std::array<float, 3> d = view.relative(p);
  std::array<double, 3> place{};
  for (std::size_t r = 0; r < 3; ++r) {
    place[r] =
        map.place[r] * d[0] + map.place[r + 4] * d[1] + map.place[r + 8] * d[2] + map.place[r + 12];
  }
  return place;
}

bool inside(const std::array<double, 3>& place) {
  return place[0] >= 0 && place[0] <= 1 && place[1] >= 0 && place[1] <= 1 && place[2] >= 0 &&
         place[2] <= 1;
}

GlView view_of(const Camera& camera) {
  return gl_view(camera, {320, 180}, {}, {0.1, 1000}, DepthMode::reversed);
}

TEST(SunMaps, HoldAllOfASceneThatIsLookedAtWhole) {
  const Box scene{{1000, 2000, 0}, {1100, 2060, 40}};
  const Camera camera = fitted(scene, {-1, -1, 1}, {320, 180});
  const GlView view = view_of(camera);
  const auto maps = sun_maps(camera, view, {}, scene);
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) != 0 ? 1100.0 : 1000.0, (i & 2) != 0 ? 2060.0 : 2000.0,
                      (i & 4) != 0 ? 40.0 : 0.0};
    EXPECT_TRUE(inside(placed(maps[0], view, corner))) << i;
  }
}

TEST(SunMaps, TheFirstIsFineAboutTheTargetInALargeScene) {
  const Box scene{{-5000, -5000, 0}, {5000, 5000, 300}};
  const Camera camera{{0, -20, 10}, {0, 0, 1}, {0, 0, 1}, 0.8};
  const GlView view = view_of(camera);
  const auto maps = sun_maps(camera, view, {}, scene);
  EXPECT_LT(maps[0].radius, 30);
  EXPECT_GT(maps[1].radius, 4 * maps[0].radius);
  EXPECT_TRUE(inside(placed(maps[0], view, camera.target)));
  EXPECT_TRUE(inside(placed(maps[1], view, {0, 60, 0}))) << "what lies behind";
  const auto low = placed(maps[0], view, {0, 0, 1});
  const auto high = placed(maps[0], view, Vec3{0, 0, 1} + Light{}.toward);
  EXPECT_NEAR(low[0], high[0], 1e-6);
  EXPECT_NEAR(low[1], high[1], 1e-6);
  EXPECT_GT(high[2], low[2]) << "the third is larger toward the sun";
}

TEST(SunMaps, WhatStandsTowardTheSunCastsAndWhatStandsBehindDoesNot) {
  const Camera camera{{0, -20, 10}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const Light light;
  const SunMap map =
      sun_maps(camera, view_of(camera), light, {{-5000, -5000, 0}, {5000, 5000, 9}})[0];
  const auto box_about = [](const Vec3& p) { return Box{p - Vec3{1, 1, 1}, p + Vec3{1, 1, 1}}; };
  EXPECT_TRUE(casts_into(map, light, box_about({0, 0, 0})));
  EXPECT_TRUE(casts_into(map, light, box_about(light.toward * 500)));
  EXPECT_FALSE(casts_into(map, light, box_about(light.toward * -500)));
  EXPECT_FALSE(casts_into(map, light, box_about({500, 0, 0})));
  EXPECT_FALSE(casts_into(map, light, {}));
}

}  // namespace
}  // namespace soms::view
