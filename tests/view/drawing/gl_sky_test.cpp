#include "apps/view/drawing/gl/gl_renderer.h"
#include "tests/view/drawing/gl_support.h"

#include <algorithm>
#include <cstdlib>

namespace soms::view {
namespace {

using test_drawing::list_of;
using test_drawing::wall;

constexpr Size kSkySize{120, 160};
constexpr DrawOptions kSkyOptions{.samples = 1, .relief = false, .shadows = false};

/// Gray at the horizon, blue above, green below.
DrawList sky() {
  DrawList list = list_of(wall(-50, -1, -1, 1, 1));  // behind the camera
  list.background = {{128, 128, 128, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}};
  return list;
}

Camera looking(double rise) {
  return {{0, -10, 0}, {0, 0, rise}, {0, 0, 1}, 0.8};
}

TEST(GlSky, StandsAboveAHorizonThatTheCameraSeesAhead) {
  SOMS_NEEDS_GL(drawing);
  drawing.renderer->draw(sky(), looking(0), kSkySize, kSkyOptions);
  const Picture level = drawing.renderer->read_pixels();
  const Color middle = level.at(60, 80);
  EXPECT_LT(std::abs(middle.b - middle.g), 12);
  EXPECT_GT(level.at(60, 0).b, middle.b + 40);
  EXPECT_LT(level.at(60, 0).g, middle.g - 40);
  EXPECT_GT(level.at(60, 159).g, middle.g + 40);
  for (int y = 1; y < kSkySize.height; ++y) {
    EXPECT_LE(std::abs(level.at(60, y).b - level.at(60, y - 1).b), 10) << "soft at " << y;
  }
}

TEST(GlSky, IsNotSeenByACameraThatLooksDown) {
  SOMS_NEEDS_GL(drawing);
  drawing.renderer->draw(sky(), looking(-9), kSkySize, kSkyOptions);
  const Picture down = drawing.renderer->read_pixels();
  for (int y = 0; y < kSkySize.height; ++y) {
    EXPECT_GT(down.at(60, y).g, down.at(60, y).b) << y;
  }
}

int saturation(Color c) {
  return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b});
}

// An ellipse on the ground about what is looked at was a border where colors changed at once.
TEST(GlSky, FarSurfacesLoseColorWithoutABorder) {
  SOMS_NEEDS_GL(drawing);
  Mesh floor;
  floor.vertices = {{-400, -20, -2}, {400, -20, -2}, {400, 780, -2}, {-400, 780, -2}};
  floor.triangles = {{0, 1, 2}, {0, 2, 3}};
  DrawList list = list_of(std::move(floor), {220, 180, 90, 255});
  list.focus = Focus{{0, 0, -2}, 4};
  const Camera camera{{0, -10, 4}, {0, 20, -2}, {0, 0, 1}, 0.8};
  drawing.renderer->draw(list, camera, kSkySize, kSkyOptions);
  const Picture picture = drawing.renderer->read_pixels();
  const auto at = [&](double y) {
    const auto seen = project(camera, kSkySize, {0, y, -2});
    return picture.at(static_cast<int>(seen->pixel.x), static_cast<int>(seen->pixel.y));
  };
  EXPECT_GT(saturation(at(0)), 90);
  EXPECT_EQ(saturation(at(1)), saturation(at(0)));
  EXPECT_LT(saturation(at(60)), saturation(at(0)) / 2);
  int last = saturation(at(0));
  for (double y = 0.5; y < 60; y += 0.5) {
    const int now = saturation(at(y));
    EXPECT_LE(now, last + 1) << y;
    EXPECT_LE(last - now, 8) << y;
    last = now;
  }
}

}  // namespace
}  // namespace soms::view
