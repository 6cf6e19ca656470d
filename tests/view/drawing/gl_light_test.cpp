#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/palette.h"
#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"
#include "tests/view/pictures.h"

#include <cstdlib>

namespace soms::view {
namespace {

using test_drawing::add_block;
using test_drawing::before_origin;
using test_drawing::list_of;
using test_drawing::wall;

constexpr Size kLit{160, 120};
constexpr DrawOptions kNoShade{.samples = 1, .relief = false, .shadows = false};
const Camera kFromAbove{{0, -0.1, 40}, {0, 0, 0}, {0, 0, 1}, 0.8};

Picture lit(GlRenderer& renderer, const DrawList& list, const Camera& camera,
            const DrawOptions& options) {
  renderer.draw(list, camera, kLit, options);
  return renderer.read_pixels();
}

/// A floor, and a slab that floats above its middle.
DrawList floor_and_slab() {
  Mesh mesh;
  add_block(mesh, {-15, -15, -1}, {15, 15, 0});
  add_block(mesh, {-2, -2, 6}, {2, 2, 6.5});
  return list_of(std::move(mesh));
}

Color at(const Picture& picture, const Camera& camera, const Vec3& place) {
  const auto seen = project(camera, picture.size, place);
  return picture.at(static_cast<int>(seen->pixel.x), static_cast<int>(seen->pixel.y));
}

TEST(GlLight, AShadowLiesWhereTheSunIsHidden) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = floor_and_slab();
  list.light.toward = {-1, 0, 1};
  const DrawOptions options{.samples = 1, .relief = false};
  for (const Vec3& shift : {Vec3{}, Vec3{1e6, -4e6, 50}}) {
    list.instances[0].pose = Pose::translation(shift.x, shift.y, shift.z);
    Camera camera = kFromAbove;
    camera.eye += shift;
    camera.target += shift;
    const Picture picture = lit(*drawing.renderer, list, camera, options);
    // 6 above the floor, the sun at 45 degrees from -x: the shadow is 6 to the +x.
    const Color shadow = at(picture, camera, shift + Vec3{6.3, 0, 0});
    const Color sunny = at(picture, camera, shift + Vec3{-6.3, 0, 0});
    EXPECT_LT(shadow.r, sunny.r - 25);
    EXPECT_EQ(at(picture, camera, shift + Vec3{6.3, 6, 0}), sunny);
    EXPECT_EQ(at(picture, camera, shift + Vec3{10, 0, 0}), sunny);
    EXPECT_EQ(at(lit(*drawing.renderer, list, camera, kNoShade), camera, shift + Vec3{6.3, 0, 0}),
              sunny)
        << "without shadows";
  }
}

// The map of the sun is about the slab, and its shadow far below.
TEST(GlLight, ShadowsAreKeptWhileTheCameraTurnsAboutItsTarget) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = floor_and_slab();
  const DrawOptions options{.samples = 1, .relief = false};
  GlRenderer& renderer = *drawing.renderer;
  const auto calls = [&](const Camera& camera) {
    (void)lit(renderer, list, camera, options);
    return renderer.statistics().draw_calls;
  };
  const std::uint64_t first = calls(kFromAbove);
  const Camera turned = orbited(kFromAbove, 0.7, -0.4);
  EXPECT_LT(calls(turned), first);
  const Picture kept = lit(renderer, list, turned, options);
  GlRenderer fresh;
  EXPECT_EQ(difference(kept, lit(fresh, list, turned, options), 4).beyond, 0U);
  EXPECT_LT(calls(turned), first);
  list.light.toward = {-1, 0, 1};  // another sun
  EXPECT_EQ(calls(turned), first);
  EXPECT_LT(calls(turned), first);
  list.instances[0].pose = Pose::translation(0.5, 0, 0);
  EXPECT_EQ(calls(turned), first);
}

TEST(GlLight, AShadowFallsOnTheGroundFarBelow) {
  SOMS_NEEDS_GL(drawing);
  Mesh slab;
  add_block(slab, {-2, -2, 6}, {2, 2, 6.5});
  DrawList list = list_of(std::move(slab));
  list.light.toward = {-1, 0, 1};
  list.ground = Ground{{0, 0, 0}, 60, palette::kGround};
  const Picture picture = lit(*drawing.renderer, list, kFromAbove, {.samples = 1, .relief = false});
  const Color sunny = at(picture, kFromAbove, {-6.3, 0, 0});
  EXPECT_LT(at(picture, kFromAbove, {6.3, 0, 0}).r, sunny.r - 25);
  EXPECT_EQ(at(picture, kFromAbove, {10, 0, 0}), sunny);
}

TEST(GlLight, ACutLeavesTheGroundWhole) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = list_of(wall(0, -1, 0, 1, 2));
  list.ground = Ground{{0, 0, 0}, 60, palette::kGround};
  Camera camera{{0, -20, 12}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const Picture whole = lit(*drawing.renderer, list, camera, kNoShade);
  camera.cut = 22;
  EXPECT_EQ(lit(*drawing.renderer, list, camera, kNoShade), whole);
}

TEST(GlLight, AGroundLiesBelowFadesOutAndIsNotSeenFromBeneath) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = list_of(wall(0, -1, 0, 1, 2));
  list.background = {{10, 20, 30, 255}, {10, 20, 30, 255}, {10, 20, 30, 255}};
  const Camera camera{{0, -20, 12}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const auto beside = [&](const Camera& from) {
    return at(lit(*drawing.renderer, list, from, kNoShade), from, {-4, 0, 0});
  };
  EXPECT_EQ(beside(camera), list.background.lower);
  list.ground = Ground{{0, 0, 0}, 12, palette::kGround};
  EXPECT_GT(beside(camera).g, 120);
  list.ground->radius = 4.2;
  EXPECT_LT(std::abs(beside(camera).g - 20), 30) << "near its edge little of it is left";
  list.ground->radius = 12;
  const Camera beneath{{0, -20, -12}, {0, 0, 0}, {0, 0, 1}, 0.8};
  EXPECT_EQ(beside(beneath), list.background.lower);
}

TEST(GlLight, RedFadesWithTheDistanceFromACurve) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = list_of(wall(0, -5, -4, 5, 4));
  const Picture plain = lit(*drawing.renderer, list, before_origin(), kNoShade);
  list.glows.push_back({{-1, 0, 0}, {1, 0, 0}, 1.5});
  const Picture picture = lit(*drawing.renderer, list, before_origin(), kNoShade);
  int last = 256;
  for (const double z : {0.1, 0.5, 0.9, 1.3}) {
    const Color c = at(picture, before_origin(), {0.3, 0, z});
    EXPECT_LT(c.r - c.g, last) << z;
    EXPECT_GT(c.r - c.g, 5) << z;
    last = c.r - c.g;
  }
  for (const Vec3& far : {Vec3{0.3, 0, 1.7}, Vec3{3, 0, 0}, Vec3{-3, 0, -2}}) {
    EXPECT_EQ(at(picture, before_origin(), far), at(plain, before_origin(), far));
  }
  // What is behind the wall is as far from the curve as it is.
  list.glows[0] = {{-1, 1.6, 0}, {1, 1.6, 0}, 1.5};
  EXPECT_EQ(lit(*drawing.renderer, list, before_origin(), kNoShade), plain);
}

TEST(GlLight, ADentIsDarkerThanAPlaneAndAPlaneIsAsItWas) {
  SOMS_NEEDS_GL(drawing);
  Mesh mesh = wall(0, -6, -6, 6, 6);
  add_block(mesh, {0, -0.4, -6}, {6, 0, 6});
  const DrawList list = list_of(std::move(mesh));
  const DrawOptions relief{.samples = 1, .shadows = false};
  const Picture with = lit(*drawing.renderer, list, before_origin(), relief);
  const Picture without = lit(*drawing.renderer, list, before_origin(), kNoShade);
  const auto darker = [&](const Vec3& p) {
    return at(without, before_origin(), p).g - at(with, before_origin(), p).g;
  };
  EXPECT_GE(darker({-0.1, 0, 0}), 5) << "beside the step";
  EXPECT_LE(std::abs(darker({-3, 0, 0})), 2) << "on the plane";
  EXPECT_LE(std::abs(darker({2, -0.4, 0})), 2) << "on the block";
}

}  // namespace
}  // namespace soms::view
