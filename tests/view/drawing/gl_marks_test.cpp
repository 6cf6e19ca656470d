// What lies over surfaces: boxes, lines, points, translucent and chosen bodies.
#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/palette.h"
#include "tests/support/support.h"
#include "tests/view/drawing/gl_support.h"
#include "tests/view/pictures.h"

#include <cmath>

namespace soms::view {
namespace {

using test_drawing::before_origin;
using test_drawing::list_of;
using test_drawing::wall;

constexpr Size kMarksSize{160, 120};
constexpr Color kMarksGround{10, 20, 30, 255};
constexpr Color kWhite{255, 255, 255, 255};
constexpr DrawOptions kOneSample{.samples = 1};

DrawList on_marks_ground(DrawList list) {
  list.background = {kMarksGround, kMarksGround, kMarksGround};
  return list;
}

Picture drawn(GlRenderer& renderer, const DrawList& list) {
  renderer.draw(list, before_origin(), kMarksSize, kOneSample);
  return renderer.read_pixels();
}

DrawList with_box(const Box& box, Color color, BoxStyle style) {
  DrawList list = on_marks_ground({});
  BoxGroup group;
  group.style = style;
  group.boxes.push_back({box, color});
  list.box_groups.push_back(group);
  return list;
}

TEST(GlBoxes, WireShowsEdgesAndLetsTheMiddleFree) {
  SOMS_NEEDS_GL(drawing);
  const Box box{{-2, -1, -2}, {2, 1, 2}};
  const Picture picture = drawn(*drawing.renderer, with_box(box, kWhite, BoxStyle::wire));
  EXPECT_EQ(picture.at(80, 60), kMarksGround);
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner{(i & 1) != 0 ? 2.0 : -2.0, (i & 2) != 0 ? 1.0 : -1.0,
                      (i & 4) != 0 ? 2.0 : -2.0};
    const PixelPoint p = project(before_origin(), kMarksSize, corner)->pixel;
    std::size_t lit = 0;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        lit += picture.at(static_cast<int>(p.x) + dx, static_cast<int>(p.y) + dy).r > 200 ? 1U : 0U;
      }
    }
    EXPECT_GT(lit, 0U) << "corner " << i;
  }
}

TEST(GlBoxes, SolidOnesHideAndTranslucentOnesMix) {
  SOMS_NEEDS_GL(drawing);
  const Box box{{-2, -1, -2}, {2, 1, 2}};
  const Color blue{0, 0, 255, 255};
  const Picture solid = drawn(*drawing.renderer, with_box(box, blue, BoxStyle::solid));
  EXPECT_GT(solid.at(80, 60).b, 120);
  EXPECT_LT(solid.at(80, 60).r, 10);
  DrawList list = with_box(box, with_alpha(blue, 80), BoxStyle::solid);
  list.points.push_back({.at = {0, 0, 0}, .color = kWhite, .diameter = 20});
  const Picture mixed = drawn(*drawing.renderer, list);
  const Color through = mixed.at(80, 60);
  EXPECT_GT(through.r, 60) << "the point inside is seen";
  EXPECT_LT(through.r, 220) << "and tinted";
}

TEST(GlBoxes, OfAMovedBodyMoveWithIt) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = with_box({{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}}, kWhite, BoxStyle::solid);
  list.box_groups[0].pose = Pose::about_z(0.7, {2, 0, 1});
  const Picture picture = drawn(*drawing.renderer, list);
  const PixelPoint p = project(before_origin(), kMarksSize, {2, 0, 1})->pixel;
  EXPECT_GT(picture.at(static_cast<int>(p.x), static_cast<int>(p.y)).r, 100);
  EXPECT_EQ(picture.at(80, 60), kMarksGround);
}

TEST(GlBoxes, AreBroughtAgainOnlyWhenTheyChange) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = with_box({{-1, -1, -1}, {1, 1, 1}}, kWhite, BoxStyle::solid);
  list.box_groups[0].key = 9;
  (void)drawn(*drawing.renderer, list);
  EXPECT_EQ(drawing.renderer->statistics().uploads, 1U);
  list.box_groups[0].boxes[0].color = {0, 255, 0, 255};
  EXPECT_GT(drawn(*drawing.renderer, list).at(80, 60).r, 100) << "same key and version";
  EXPECT_EQ(drawing.renderer->statistics().uploads, 0U);
  list.box_groups[0].version = 1;
  EXPECT_LT(drawn(*drawing.renderer, list).at(80, 60).r, 10);
  EXPECT_EQ(drawing.renderer->statistics().uploads, 1U);
}

TEST(GlStrokes, LinesKeepTheirWidthAtAnyDistance) {
  SOMS_NEEDS_GL(drawing);
  for (const double depth : {-8.0, 0.0, 500.0}) {
    DrawList list = on_marks_ground({});
    const double reach = 100 * (depth + 10);
    list.lines.push_back(
        {.a = {0, depth, -reach}, .b = {0, depth, reach}, .color = kWhite, .width = 4});
    const Picture picture = drawn(*drawing.renderer, list);
    EXPECT_EQ(count_near(picture, kWhite, 2), 4U * 120U) << "at depth " << depth;
  }
}

TEST(GlStrokes, LinesFromBehindTheEyeAreCut) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground({});
  list.lines.push_back({.a = {0, -60, -1}, .b = {0, 40, 1}, .color = kWhite, .width = 2});
  const Picture picture = drawn(*drawing.renderer, list);
  const PixelPoint end = project(before_origin(), kMarksSize, {0, 39.5, 0.99})->pixel;
  EXPECT_EQ(picture.at(static_cast<int>(end.x), static_cast<int>(end.y)), kWhite);
  const PixelPoint middle = project(before_origin(), kMarksSize, {0, -9, 0.02})->pixel;
  EXPECT_EQ(picture.at(static_cast<int>(middle.x), static_cast<int>(middle.y)), kWhite);
  list.lines[0].b = {0, -30, 1};
  EXPECT_EQ(count_near(drawn(*drawing.renderer, list), kWhite, 2), 0U) << "all of it is behind";
}

TEST(GlStrokes, PointsAreRoundAndAsLargeAsRequested) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground({});
  list.points.push_back({.at = {0, 0, 0}, .color = kWhite, .diameter = 30});
  const Picture picture = drawn(*drawing.renderer, list);
  const std::size_t pixels = picture.bytes.size() / 4;
  const auto lit = static_cast<double>(pixels - count_near(picture, kMarksGround, 2));
  EXPECT_NEAR(lit, 707, 70);
  EXPECT_EQ(picture.at(80 - 13, 60 - 13), kMarksGround) << "no square";
}

TEST(GlStrokes, OnSurfacesShowWholeWithoutFlicker) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground(list_of(wall(0, -9, -9, 9, 9), {60, 60, 60, 255}));
  const Camera slanted{{-4, -6, 3}, {0, 0, 0}, {0, 0, 1}, 0.8};
  list.lines.push_back({.a = {-2, 0, -1}, .b = {2, 0, 1}, .color = kWhite, .width = 3});
  drawing.renderer->draw(list, slanted, kMarksSize, kOneSample);
  const Picture over = drawing.renderer->read_pixels();
  list.lines[0].on_top = true;
  drawing.renderer->draw(list, slanted, kMarksSize, kOneSample);
  const Picture top = drawing.renderer->read_pixels();
  EXPECT_GT(count_near(over, kWhite, 2), 100U);
  EXPECT_EQ(count_near(over, kWhite, 2), count_near(top, kWhite, 2));
}

TEST(GlMarks, AreAsOpaqueAsTheirColor) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground(list_of(wall(0, -9, -9, 9, 9), {200, 200, 200, 255}));
  const Color surface = drawn(*drawing.renderer, list).at(80, 60);
  list.marks.push_back({.corners = {{-9, 0, -9}, {9, 0, -9}, {0, 0, 9}}, .color = {0, 0, 0, 255}});
  EXPECT_LT(drawn(*drawing.renderer, list).at(80, 60).r, 5);
  list.marks[0].color.a = 128;
  EXPECT_NEAR(drawn(*drawing.renderer, list).at(80, 60).r, surface.r / 2, 4);
}

TEST(GlSurfaces, TranslucentBodiesShowWhatIsBehindOnce) {
  SOMS_NEEDS_GL(drawing);
  Mesh two = wall(-1, -3, -3, 3, 3);
  append(two, wall(1, -3, -3, 3, 3));
  DrawList list = on_marks_ground(list_of(two, {255, 255, 255, 128}));
  const Picture glass = drawn(*drawing.renderer, list);
  list.meshes[0] = {.key = 2, .mesh = std::make_shared<const Mesh>(wall(-1, -3, -3, 3, 3))};
  const Picture pane = drawn(*drawing.renderer, list);
  EXPECT_GT(pane.at(80, 60).r, kMarksGround.r + 40);
  EXPECT_LT(pane.at(80, 60).r, 200);
  EXPECT_EQ(glass.at(80, 60), pane.at(80, 60)) << "the nearest face alone";
}

TEST(GlSurfaces, WireLeavesFacesOpenAndBothShadesTheirEdges) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground(list_of(wall(0, -3, -3, 3, 3)));
  const Picture solid = drawn(*drawing.renderer, list);
  list.instances[0].style = SurfaceStyle::wire;
  const Picture wire = drawn(*drawing.renderer, list);
  list.instances[0].style = SurfaceStyle::both;
  const Picture both = drawn(*drawing.renderer, list);
  EXPECT_EQ(wire.at(90, 65), kMarksGround);
  EXPECT_LT(count_near(wire, kMarksGround, 2), 160U * 120U - 200U) << "edges are there";
  EXPECT_EQ(both.at(90, 65), solid.at(90, 65));
  EXPECT_GT(difference(solid, both, 20).beyond, 200U);
}

TEST(GlSurfaces, ChosenBodiesAreBrighter) {
  SOMS_NEEDS_GL(drawing);
  DrawList list = on_marks_ground(list_of(wall(0, -3, -3, 3, 3), {100, 50, 50, 255}));
  const Color plain = drawn(*drawing.renderer, list).at(80, 60);
  list.instances[0].highlighted = true;
  const Color chosen = drawn(*drawing.renderer, list).at(80, 60);
  EXPECT_GT(chosen.r, plain.r + 20);
  EXPECT_GT(chosen.g, plain.g + 20);
}

TEST(GlRendererErrors, RefuseImpossibleSizesAndGoOn) {
  SOMS_NEEDS_GL(drawing);
  GlRenderer& renderer = *drawing.renderer;
  EXPECT_THROW((void)renderer.read_pixels(), Error);
  EXPECT_THROW(renderer.draw({}, {}, {0, 10}), Error);
  EXPECT_THROW(renderer.draw({}, {}, {10, 1 << 20}), Error);
  DrawList wrong;
  wrong.instances.resize(1);
  EXPECT_THROW(renderer.draw(wrong, {}, kMarksSize), Error);
  renderer.draw({}, {}, {7, 3});
  EXPECT_EQ(renderer.read_pixels().size, (Size{7, 3}));
}

TEST(GlRendererErrors, AnyScaleAndAnyMeshIsDrawnWithoutHarm) {
  SOMS_NEEDS_GL(drawing);
  for (const double scale : {1e-20, 1e-3, 1e30, 1e80}) {
    DrawList list = on_marks_ground(list_of(wall(0, -3 * scale, -3 * scale, 3 * scale, 3 * scale)));
    list.meshes[0].key = static_cast<std::uint64_t>(std::log10(scale) + 100);
    const Camera camera{{0, -10 * scale, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
    drawing.renderer->draw(list, camera, kMarksSize, kOneSample);
    EXPECT_GT(drawing.renderer->read_pixels().at(80, 60).r, 60) << "at scale " << scale;
  }
  DrawList list = on_marks_ground(list_of(Mesh{}));
  drawing.renderer->draw(list, before_origin(), kMarksSize, kOneSample);
  EXPECT_EQ(count_near(drawing.renderer->read_pixels(), kMarksGround, 1), 160U * 120U);
  Mesh point;
  point.vertices = {{0, 0, 0}};
  point.triangles = {{0, 0, 0}};
  EXPECT_NO_THROW(drawing.renderer->draw(list_of(point), before_origin(), kMarksSize, kOneSample));
}

}  // namespace
}  // namespace soms::view
