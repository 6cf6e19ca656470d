#include "apps/view/drawing/gap_marks.h"

#include "tests/view/drawing/gl_support.h"
#include "tests/view/pictures.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace soms::view {
namespace {

using test_drawing::before_origin;
using test_drawing::list_of;
using test_drawing::wall;

constexpr Size kGapSize{320, 240};
constexpr Color kGapGround{150, 170, 200, 255};
constexpr DrawOptions kGapOptions{.samples = 1, .relief = false};

DrawList with_gap(DrawList list, const GapMark& gap) {
  list.background = {kGapGround, kGapGround, kGapGround};
  add_gap(list, gap);
  return list;
}

Picture drawn_gap(GlRenderer& renderer, const DrawList& list) {
  renderer.draw(list, before_origin(), kGapSize, kGapOptions);
  return renderer.read_pixels();
}

Color at(const Picture& picture, const Vec3& point) {
  const PixelPoint p = project(before_origin(), picture.size, point)->pixel;
  return picture.at(static_cast<int>(p.x), static_cast<int>(p.y));
}

TEST(GapMarks, AreALineTwoEndsAndALengthTwice) {
  const GapMark gap{.point_a = {1, 2, 3}, .point_b = {4, 5, 6}, .length = "5.196"};
  DrawList list;
  add_gap(list, gap);
  // Once where surfaces may hide them, and once pale over everything.
  ASSERT_EQ(list.lines.size(), 2U);
  ASSERT_EQ(list.points.size(), 4U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(list.lines[k].a, gap.point_a);
    EXPECT_EQ(list.lines[k].b, gap.point_b);
    EXPECT_EQ(list.lines[k].on_top, k == 1);
    EXPECT_EQ(list.lines[k].color.a < 255, k == 1);
    EXPECT_EQ(list.points[2 * k].at, gap.point_a);
    EXPECT_EQ(list.points[2 * k + 1].at, gap.point_b);
    EXPECT_EQ(list.points[2 * k].on_top, k == 1);
  }
  ASSERT_EQ(list.labels.size(), 1U);
  EXPECT_EQ(list.labels[0].text, "5.196");
  EXPECT_EQ(list.labels[0].a, gap.point_a);
  EXPECT_EQ(list.labels[0].b, gap.point_b);
  EXPECT_EQ(bounds(list), (Box{{1, 2, 3}, {4, 5, 6}}));
  add_gap(list, {.point_a = {0, 0, 0}, .point_b = {1, 0, 0}});
  EXPECT_EQ(list.lines.size(), 4U);
  EXPECT_EQ(list.labels.size(), 1U) << "no length, no label";
}

TEST(GlGapMarks, EndsAreOneSizeHoweverFarAndShort) {
  SOMS_NEEDS_GL(drawing);
  const auto ink = [&](double depth, double length) {
    const double reach = 0.5 * length;
    const GapMark gap{.point_a = {-reach, depth, 0}, .point_b = {reach, depth, 0}};
    return count_near(drawn_gap(*drawing.renderer, with_gap({}, gap)), palette::kGap, 6);
  };
  const std::size_t dot = ink(0, 0);
  EXPECT_GT(dot, 40U);
  EXPECT_LT(dot, 110U);
  EXPECT_EQ(ink(500, 0), dot);
  EXPECT_EQ(ink(-8, 0), dot);
  EXPECT_EQ(ink(0, 1e-12), dot) << "a gap that nobody could see";
  EXPECT_GT(ink(0, 2), 2 * dot);
}

TEST(GlGapMarks, ArePaleBehindASurfaceAndInkBeforeIt) {
  SOMS_NEEDS_GL(drawing);
  const Color gray{200, 200, 200, 255};
  const GapMark gap{.point_a = {-2, 0, 0}, .point_b = {2, 0, 0}};
  const Picture before =
      drawn_gap(*drawing.renderer, with_gap(list_of(wall(1, -9, -9, 9, 9), gray), gap));
  DrawList other = list_of(wall(-1, -9, -9, 9, 9), gray);
  other.meshes[0].version = 1;
  const Picture behind = drawn_gap(*drawing.renderer, with_gap(std::move(other), gap));
  for (const Vec3& p : {gap.point_a, gap.point_b, Vec3{0, 0, 0}, Vec3{1, 0, 0}}) {
    EXPECT_EQ(at(before, p), palette::kGap);
    const Color surface = at(behind, p + Vec3{0, 0, 2});
    const Color pale = at(behind, p);
    EXPECT_LT(pale.r, surface.r - 25) << "seen through the wall";
    EXPECT_GT(pale.r, palette::kGap.r + 30) << "and paler than before it";
  }
}

TEST(GlGapMarks, HaveARimThatSetsThemOffFromDarkSurfaces) {
  SOMS_NEEDS_GL(drawing);
  const GapMark gap{.point_a = {-2, 0, 0}, .point_b = {2, 0, 0}};
  DrawList list = list_of(wall(1, -9, -9, 9, 9), {30, 30, 30, 255});
  const std::size_t without = count_near(drawn_gap(*drawing.renderer, list), palette::kPaper, 20);
  const std::size_t with =
      count_near(drawn_gap(*drawing.renderer, with_gap(list, gap)), palette::kPaper, 20);
  EXPECT_EQ(without, 0U);
  EXPECT_GT(with, 200U);
}

TEST(GlGapMarks, WriteTheLengthInInkOnPaperOverEverything) {
  SOMS_NEEDS_GL(drawing);
  GapMark gap{.point_a = {-1, 0, 0}, .point_b = {1, 0, 0}};
  const DrawList wall_before = list_of(wall(-2, -9, -9, 9, 9), {90, 90, 200, 255});
  const Picture plain = drawn_gap(*drawing.renderer, with_gap(wall_before, gap));
  EXPECT_EQ(drawing.renderer->statistics().labels, 0U);
  gap.length = "0.25";
  const Picture written = drawn_gap(*drawing.renderer, with_gap(wall_before, gap));
  EXPECT_EQ(drawing.renderer->statistics().labels, 1U);
  EXPECT_GT(count_near(written, palette::kGap, 40), count_near(plain, palette::kGap, 40) + 60);
  EXPECT_GT(count_near(written, palette::kPaper, 10), count_near(plain, palette::kPaper, 10) + 200);
  // All of it stands above the line.
  int lowest = 0;
  for (int y = 0; y < kGapSize.height; ++y) {
    for (int x = 0; x < kGapSize.width; ++x) {
      lowest = written.at(x, y) == plain.at(x, y) ? lowest : std::max(lowest, y);
    }
  }
  EXPECT_GT(lowest, 90);
  EXPECT_LT(lowest, 120);
}

TEST(GlGapMarks, GiveTheSamePictureEachTimeAndFarFromTheOrigin) {
  SOMS_NEEDS_GL(drawing);
  const auto picture = [&](const Vec3& origin) {
    DrawList list;
    for (int k = 0; k < 40; ++k) {
      add_gap(list, {.point_a = origin + Vec3{-3.0 + 0.25 * k, 0, -2},
                     .point_b = origin + Vec3{-3.0 + 0.125 * k, 1, 2},
                     .length = std::to_string(k) + ".5 m"});
    }
    Camera camera = before_origin();
    camera.eye += origin;
    camera.target += origin;
    drawing.renderer->draw(list, camera, kGapSize, {});
    return drawing.renderer->read_pixels();
  };
  const Picture first = picture({});
  EXPECT_EQ(drawing.renderer->statistics().lines, 80U);
  EXPECT_GT(drawing.renderer->statistics().labels, 2U);
  EXPECT_LT(drawing.renderer->statistics().labels, 40U) << "those that have room";
  EXPECT_EQ(first.bytes, picture({}).bytes);
  EXPECT_EQ(first.bytes, picture({1 << 20, -(1 << 21), 1 << 10}).bytes);
}

}  // namespace
}  // namespace soms::view
