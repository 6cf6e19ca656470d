#include "apps/view/drawing/gl/gl_renderer.h"

#include "apps/view/drawing/palette.h"
#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"
#include "tests/view/pictures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <stop_token>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

using test_drawing::before_origin;
using test_drawing::blocks;
using test_drawing::list_of;
using test_drawing::wall;

constexpr Size kSmall{160, 120};
constexpr Color kGround{10, 20, 30, 255};
constexpr DrawOptions kPlain{.samples = 1};

// A list on an even ground that no mark resembles.
DrawList on_ground(DrawList list) {
  list.background = {kGround, kGround, kGround};
  return list;
}

Picture drawn(GlRenderer& renderer, const DrawList& list, const Camera& camera, Size size = kSmall,
              const DrawOptions& options = kPlain) {
  renderer.draw(list, camera, size, options);
  return renderer.read_pixels();
}

bool reddish(Color c) {
  return c.r > 130 && c.g < 90 && c.b < 90;
}

std::size_t count_red(const Picture& picture) {
  std::size_t count = 0;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      count += reddish(picture.at(x, y)) ? 1U : 0U;
    }
  }
  return count;
}

TEST(GlRenderer, FillsAnEmptyPictureWithTheBackground) {
  SOMS_NEEDS_GL(drawing);
  const Picture picture = drawn(*drawing.renderer, on_ground({}), {});
  EXPECT_EQ(count_near(picture, kGround, 1), 160U * 120U);
}

TEST(GlRenderer, PutsRightAndUpWhereTheyBelong) {
  SOMS_NEEDS_GL(drawing);
  const DrawList list = on_ground(list_of(wall(0, 1, 1, 2, 2)));
  const Picture picture = drawn(*drawing.renderer, list, before_origin());
  const auto middle = project(before_origin(), kSmall, {1.5, 0, 1.5});
  const int x = static_cast<int>(middle->pixel.x);
  const int y = static_cast<int>(middle->pixel.y);
  EXPECT_GT(x, 80);
  EXPECT_LT(y, 60);
  EXPECT_GT(picture.at(x, y).r, 60) << "the wall is lit";
  EXPECT_EQ(picture.at(160 - x, y), kGround);
  EXPECT_EQ(picture.at(x, 120 - y), kGround);
}

TEST(GlRenderer, DrawsTheSameInPartsAndStopsBetweenThem) {
  SOMS_NEEDS_GL(drawing);
  DrawList many = on_ground(list_of(blocks(12)));
  many.instances.resize(100, many.instances[0]);
  for (std::size_t k = 0; k < many.instances.size(); ++k) {
    many.instances[k].pose = Pose::translation(0, static_cast<double>(k), 0);
  }
  DrawList one = on_ground(list_of(wall(0, -3, -3, 3, 3)));
  one.marks.push_back({{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, palette::kContact});
  GlRenderer& renderer = *drawing.renderer;
  // Copies of more triangles than a part has, then more rows than a band has.
  for (const auto& [list, size] : {std::pair(many, kSmall), std::pair(one, Size{1050, 1000})}) {
    (void)drawn(renderer, list, before_origin(), size);  // shadows are kept from then on
    const Picture whole = drawn(renderer, list, before_origin(), size);
    const std::uint64_t calls = renderer.statistics().draw_calls;
    std::vector<double> shares;
    std::stop_source source;
    renderer.watch(
        {.stop = source.get_token(), .progress = [&](double share) { shares.push_back(share); }});
    EXPECT_EQ(drawn(renderer, list, before_origin(), size), whole);
    EXPECT_GT(renderer.statistics().draw_calls, calls);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_GT(shares.back(), 0.7);
    source.request_stop();
    EXPECT_THROW(drawn(renderer, list, before_origin(), size), Error);
    renderer.watch({});
  }
}

TEST(GlRenderer, ShowsRedWhereMarksAreAndNowhereElse) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_ground(list_of(wall(0, -3, -3, 3, 3)));
  EXPECT_EQ(count_red(drawn(*drawing.renderer, list, before_origin())), 0U);
  list.marks.push_back({{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, palette::kContact});
  const Picture picture = drawn(*drawing.renderer, list, before_origin());
  const double pixel = length_of_pixel(before_origin(), kSmall, 10);
  const double wanted = 2.0 / (pixel * pixel);  // its area
  EXPECT_NEAR(static_cast<double>(count_red(picture)), wanted, 0.05 * wanted + 20);
  EXPECT_TRUE(reddish(picture.at(80, 62)));
  EXPECT_EQ(drawing.renderer->statistics().marks, 1U);
}

TEST(GlRenderer, HidesMarksBehindSurfacesUnlessTheyAreOnTop) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_ground(list_of(wall(0, -3, -3, 3, 3)));
  list.marks.push_back({{{-1, 1, -1}, {1, 1, -1}, {0, 1, 1}}, palette::kContact});
  EXPECT_EQ(count_red(drawn(*drawing.renderer, list, before_origin())), 0U);
  list.marks[0].on_top = true;
  EXPECT_GT(count_red(drawn(*drawing.renderer, list, before_origin())), 100U);
}

TEST(GlRenderer, LeavesOutWhatIsNearerThanTheCut) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_ground(list_of(wall(-4, -3, -3, 3, 3)));
  list.marks.push_back({{{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}, palette::kContact});
  Camera camera = before_origin();
  EXPECT_EQ(count_red(drawn(*drawing.renderer, list, camera)), 0U) << "behind the wall";
  camera.cut = 5.5;  // the wall is 6 before the eye
  EXPECT_EQ(count_red(drawn(*drawing.renderer, list, camera)), 0U);
  camera.cut = 6.5;
  EXPECT_GT(count_red(drawn(*drawing.renderer, list, camera)), 100U);
}

TEST(GlRenderer, DrawsTheSamePictureFarFromTheOrigin) {
  SOMS_NEEDS_GL(drawing);
  const Camera camera{{-150, -260, 140}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const Size size{320, 240};
  const Picture here = drawn(*drawing.renderer, list_of(blocks(16)), camera, size);
  for (const Vec3& shift : {Vec3{1e6, 5e6, 300}, Vec3{-3e7, 1e7, 0}}) {
    Camera there = camera;
    there.eye += shift;
    there.target += shift;
    DrawList list = list_of(blocks(16, shift));
    list.meshes[0].version = static_cast<std::uint64_t>(std::abs(shift.x));
    const PictureDifference d = difference(here, drawn(*drawing.renderer, list, there, size), 8);
    EXPECT_LE(d.beyond, 8U) << "of 76,800 pixels";
    EXPECT_LT(d.mean, 0.05);
    DrawList placed = list_of(blocks(16));
    placed.meshes[0].version = 17;
    placed.instances[0].pose = Pose::translation(shift.x, shift.y, shift.z);
    EXPECT_LE(difference(here, drawn(*drawing.renderer, placed, there, size), 8).beyond, 8U)
        << "a body that was moved there";
  }
}

TEST(GlRenderer, DoesNotShakeAtMapCoordinates) {
  SOMS_NEEDS_GL(drawing);
  // Millimeter steps of the camera past a point of a map, 2.5 m away: it must move by less than a
  // pixel a step and never jump.
  const Vec3 place{1234567.25, 7654321.5, 40};
  double last = -1;
  for (int step = 0; step < 40; ++step) {
    DrawList list = on_ground({});
    list.points.push_back({.at = place, .color = {255, 255, 255, 255}, .diameter = 5});
    Camera camera{{place.x + 0.001 * step, place.y - 2.5, place.z}, {}, {0, 0, 1}, 0.8};
    camera.target = camera.eye + Vec3{0, 2.5, 0};
    const Picture picture = drawn(*drawing.renderer, list, camera, {400, 300});
    double sum = 0;
    double weight = 0;
    for (int y = 140; y < 160; ++y) {
      for (int x = 150; x < 250; ++x) {
        const double lit = picture.at(x, y).r - kGround.r;
        sum += lit * (x + 0.5);
        weight += lit;
      }
    }
    ASSERT_GT(weight, 1000);
    const double at = sum / weight;
    EXPECT_NEAR(at, project(camera, {400, 300}, place)->pixel.x, 0.1);
    if (last >= 0) {
      EXPECT_NEAR(at, last, 0.3);
    }
    last = at;
  }
}

TEST(GlRenderer, KeepsNearWallsBeforeFarOnesAcrossACity) {
  SOMS_NEEDS_GL(drawing);
  // Two walls 10 cm apart, 4 km away, from an eye that could see a hand before it.
  Mesh two = wall(4000, -500, -500, 500, 500);
  append(two, wall(4000.1, -500, -500, 500, 500));
  DrawList list = on_ground(list_of(two));
  const Color front{0, 200, 0, 255};
  const Color back{200, 0, 0, 255};
  list.meshes[0].colors =
      std::make_shared<const std::vector<Color>>(std::vector<Color>{front, front, back, back});
  const Camera camera{{0, 0, 0}, {3, 50, 1}, {0, 0, 1}, 0.4};
  const Picture picture = drawn(*drawing.renderer, list, camera, {320, 240});
  std::size_t red = 0;
  std::size_t green = 0;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      red += picture.at(x, y).r > 60 ? 1U : 0U;
      green += picture.at(x, y).g > 60 ? 1U : 0U;
    }
  }
  EXPECT_EQ(red, 0U);
  EXPECT_GT(green, 10000U);
}

TEST(GlRenderer, DrawsThousandsOfCopiesAndBoxesInAFewCalls) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = list_of(blocks(2));
  for (int i = 1; i < 2000; ++i) {
    list.instances.push_back({.mesh = 0, .pose = Pose::translation(60.0 * (i % 50), 3.0 * i, 0)});
  }
  BoxGroup group;
  group.key = 5;
  for (int i = 0; i < 5000; ++i) {
    const int row = i / 70;
    const Vec3 at{3.0 * (i % 70), 3.0 * row, 0};
    group.boxes.push_back({{at, at + Vec3{2, 2, 2}}});
    list.lines.push_back({.a = at, .b = at + Vec3{0, 0, 30}});
    list.points.push_back({.at = at});
    list.marks.push_back({{at, at + Vec3{1, 0, 0}, at + Vec3{0, 1, 0}}});
  }
  list.box_groups.push_back(group);
  const Camera camera{{1500, -1500, 1500}, {1500, 3000, 0}, {0, 0, 1}, 1.2};
  drawing.renderer->draw(list, camera, kSmall, kPlain);
  const DrawStatistics first = drawing.renderer->statistics();
  EXPECT_LE(first.draw_calls, 12U);
  EXPECT_EQ(first.instances, 2000U);
  EXPECT_EQ(first.boxes, 5000U);
  EXPECT_EQ(first.lines, 5000U);
  EXPECT_EQ(first.points, 5000U);
  EXPECT_EQ(first.uploads, 2U) << "the mesh and the boxes";
  drawing.renderer->draw(list, camera, kSmall, kPlain);
  EXPECT_EQ(drawing.renderer->statistics().uploads, 0U);
}

TEST(GlRenderer, BoundsItsCallsForALargeMeshAndLeavesOutWhatIsNotSeen) {
  SOMS_NEEDS_GL(drawing);
  const DrawList list = list_of(blocks(150));  // 270,000 triangles, 17 tiles
  const Camera above{{0, -1500, 2500}, {0, 0, 0}, {0, 0, 1}, 1.4};
  drawing.renderer->draw(list, above, kSmall, kPlain);
  const DrawStatistics whole = drawing.renderer->statistics();
  EXPECT_EQ(whole.triangles, 270000U);
  EXPECT_EQ(whole.tiles, 17U);
  EXPECT_LE(whole.draw_calls, 2U * 17U + 8U) << "the picture, and the sun's view";
  const Camera corner{{-1480, -1480, 20}, {-1500, -1500, 0}, {0, 0, 1}, 0.5};
  drawing.renderer->draw(list, corner, kSmall, kPlain);
  EXPECT_LT(drawing.renderer->statistics().tiles_drawn, 6U);
}

TEST(GlRenderer, ShowsMostOfASceneWithASmallPartOfItsTriangles) {
  SOMS_NEEDS_GL(drawing);
  const DrawList list = on_ground(list_of(blocks(60)));
  const Camera camera{{0, -900, 700}, {0, 0, 0}, {0, 0, 1}, 0.9};
  const Picture whole = drawn(*drawing.renderer, list, camera);
  const Picture part =
      drawn(*drawing.renderer, list, camera, kSmall, {.most_triangles = 20000, .samples = 1});
  const DrawStatistics s = drawing.renderer->statistics();
  EXPECT_LE(s.triangles, 20000U);
  EXPECT_EQ(s.triangles + s.triangles_left, 43200U);
  const auto covered = [&](const Picture& p) {
    const std::size_t pixels = p.bytes.size() / 4;
    return static_cast<double>(pixels - count_near(p, kGround, 2));
  };
  EXPECT_GT(covered(part), 0.6 * covered(whole));
}

TEST(GlRenderer, DarkensCreasesAndStepsButNoPlaneHoweverSlanted) {
  SOMS_NEEDS_GL(drawing);
  const Camera slanted{{-6, -10, 5}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const auto darker = [&](Mesh mesh, std::uint64_t key) {
    DrawList list = on_ground(list_of(std::move(mesh)));
    list.meshes[0].key = key;
    const Picture flat =
        drawn(*drawing.renderer, list, slanted, kSmall, {.samples = 1, .relief = false});
    const Picture relief = drawn(*drawing.renderer, list, slanted);
    return difference(flat, relief, 2).beyond;
  };
  EXPECT_EQ(darker(wall(0, -3, -3, 3, 3), 1), 0U);
  Mesh step = wall(0, -3, -3, 3, 3);
  append(step, wall(-0.3, -1, -1, 1, 1));
  EXPECT_GT(darker(step, 2), 30U);
}

TEST(GlRenderer, SmoothsEdgesWithMoreSamples) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_ground({});
  list.lines.push_back(
      {.a = {-3, 0, -1}, .b = {3, 0, 1}, .color = {255, 255, 255, 255}, .width = 3});
  const Picture rough = drawn(*drawing.renderer, list, before_origin());
  const Picture smooth = drawn(*drawing.renderer, list, before_origin(), kSmall, {.samples = 4});
  const auto between = [](const Picture& p) {
    return p.bytes.size() / 4 - count_near(p, kGround, 3) - count_near(p, {255, 255, 255, 255}, 3);
  };
  EXPECT_EQ(between(rough), 0U);
  EXPECT_GT(between(smooth), 50U);
}

TEST(GlRenderer, DrawsFewerPixelsOfTheSamePictureAndStretchesThem) {
  SOMS_NEEDS_GL(drawing);
  const DrawList list = on_ground(list_of(wall(0, -3, -3, 3, 3)));
  drawing.renderer->draw(list, before_origin(), {200, 100}, {.samples = 1});
  const Picture whole = drawing.renderer->read_pixels();
  drawing.renderer->draw(list, before_origin(), {200, 100}, {.samples = 1, .scale = 0.5});
  const Picture half = drawing.renderer->read_pixels();
  EXPECT_EQ(half.size, whole.size);
  for (const auto& [x, y] : {std::pair(100, 50), std::pair(10, 10), std::pair(190, 90)}) {
    const Color a = whole.at(x, y);
    const Color b = half.at(x, y);
    EXPECT_LE(std::abs(a.r - b.r), 3) << x << ' ' << y;
  }
}

/// Ink of the key, and a curve, over a scene.
DrawList with_words() {
  DrawList list = on_ground(list_of(wall(0, -3, -3, 3, 3)));
  list.captions.key = {{KeySign::area, {0, 0, 255, 255}, "moves: car"},
                       {KeySign::area, {0, 160, 0, 255}, "at rest"}};
  return list;
}

TEST(GlRenderer, WhatIsWrittenIsAsSharpOverFewPixelsOfTheScene) {
  SOMS_NEEDS_GL(drawing);
  const auto words = [&](double scale) {
    const DrawOptions options{.samples = 1, .scale = scale, .relief = false, .shadows = false};
    drawing.renderer->draw(with_words(), before_origin(), {400, 240}, options);
    return drawing.renderer->read_pixels();
  };
  const Picture sharp = words(1);
  const Picture moving = words(0.49);
  const Color ink = palette::kInk;
  EXPECT_GT(count_near(sharp, ink, 8), 200U);
  EXPECT_EQ(count_near(moving, ink, 8), count_near(sharp, ink, 8));
  EXPECT_EQ(count_near(moving, {0, 0, 255, 255}, 8), count_near(sharp, {0, 0, 255, 255}, 8));
}

TEST(GlRenderer, StrokesAndWordsGrowWithTheDensityOfTheDisplay) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = with_words();
  list.lines.push_back({.a = {-2, -1, 1}, .b = {2, -1, 1}, .color = {255, 0, 0, 255}, .width = 4});
  list.points.push_back({.at = {0, -1, 0}, .color = {255, 0, 255, 255}, .diameter = 24});
  list.captions.covered = 0.25;
  const auto drawn_at = [&](double density) {
    const DrawOptions options{.samples = 1, .density = density, .relief = false, .shadows = false};
    const Size size{static_cast<int>(360 * density), static_cast<int>(240 * density)};
    drawing.renderer->draw(list, before_origin(), size, options);
    return drawing.renderer->read_pixels();
  };
  const Picture one = drawn_at(1);
  const Picture two = drawn_at(2);
  for (const Color color :
       {palette::kInk, Color{255, 0, 0, 255}, Color{0, 0, 255, 255}, Color{255, 0, 255, 255}}) {
    const auto small = static_cast<double>(count_near(one, color, 60));
    ASSERT_GT(small, 40);
    // Twice as long and as wide; rims of letters are blended.
    EXPECT_NEAR(static_cast<double>(count_near(two, color, 60)) / small, 4, 1.2)
        << int{color.r} << ' ' << int{color.g} << ' ' << int{color.b};
  }
  const auto leftmost = [](const Picture& picture) {
    for (int x = 0; x < picture.size.width; ++x) {
      for (int y = 0; y < picture.size.height; ++y) {
        const Color c = picture.at(x, y);
        if (c.b > 200 && c.r < 60 && c.g < 60) {
          return x;
        }
      }
    }
    return -1;
  };
  EXPECT_GT(leftmost(one), 90) << "beside what covers a quarter";
  EXPECT_NEAR(leftmost(two), 2 * leftmost(one), 2);
}

}  // namespace
}  // namespace soms::view
