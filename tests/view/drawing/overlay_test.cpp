#include "apps/view/drawing/overlay.h"

#include "apps/view/drawing/palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soms::view {
namespace {

constexpr Size kOverlaid{640, 360};
const Camera kAbove{{0, -50, 50}, {0, 0, 0}, {0, 0, 1}, 0.8};

DrawList with_key() {
  DrawList list;
  list.captions.key = {{KeySign::area, palette::kBodyA, "moves"},
                       {KeySign::curve, palette::kContact, "contact"},
                       {KeySign::marker, palette::kContact, "n movers in contact"}};
  return list;
}

std::size_t red(const Overlay& overlay) {
  return static_cast<std::size_t>(
      std::count_if(overlay.strokes.begin(), overlay.strokes.end(),
                    [](const OverlayStroke& s) { return s.color == palette::kContact; }));
}

TEST(Overlay, TheKeyNamesContactsOnlyWhereThePictureShowsThem) {
  DrawList list = with_key();
  EXPECT_EQ(red(overlay_of(list, kAbove, kOverlaid)), 0U);
  list.glows.push_back({{0, 0, 0}, {1, 0, 0}, 1});
  EXPECT_EQ(red(overlay_of(list, kAbove, kOverlaid)), 1U) << "the sign of the curve";
  list.glows[0] = {{0, 900, 0}, {1, 900, 900}, 1};
  EXPECT_EQ(red(overlay_of(list, kAbove, kOverlaid)), 0U) << "it is out of the picture";
  list.markers.push_back({.at = {0, 0, 0}, .count = 12, .color = palette::kContact});
  const Overlay marked = overlay_of(list, kAbove, kOverlaid);
  EXPECT_EQ(red(marked), 2U) << "the marker and its sign";
  EXPECT_EQ(marked.markers, 1U);
  EXPECT_EQ(marked.marked, 12U);
}

TEST(Overlay, TheKeyNamesOnlyWhatIsInThePicture) {
  DrawList list;
  list.captions.key = {{KeySign::area, palette::kBodyA, "moves", {{900, 900, 0}, {900, -900, 0}}}};
  EXPECT_TRUE(overlay_of(list, kAbove, kOverlaid).strokes.empty());
  list.captions.key[0].places.push_back({1, 2, 0});
  EXPECT_FALSE(overlay_of(list, kAbove, kOverlaid).strokes.empty());
}

TEST(Overlay, StaysInsideThePictureAndTinyPicturesHaveNoWords) {
  DrawList list = with_key();
  list.captions.title = "A title";
  list.captions.meters = 1;
  list.captions.north = true;
  for (const Vec3& eye : {Vec3{0, -50, 50}, Vec3{50, 0, 50}, Vec3{-50, 0, 20}, Vec3{0, 50, 50}}) {
    const Overlay overlay = overlay_of(list, {eye, {0, 0, 0}, {0, 0, 1}, 0.8}, kOverlaid);
    EXPECT_GT(overlay.strokes.size(), 50U);
    for (const OverlayStroke& s : overlay.strokes) {
      for (const PixelPoint& p : {s.from, s.to}) {
        EXPECT_TRUE(p.x > 4 && p.x < kOverlaid.width - 4 && p.y > 4 && p.y < kOverlaid.height - 4);
      }
    }
  }
  EXPECT_TRUE(overlay_of(list, kAbove, {90, 60}).strokes.empty());
}

TEST(Overlay, TheScaleBarIsRoundAndFitsWhatAPixelIs) {
  for (const double meters : {1.0, 0.01, 1000.0}) {
    for (const double distance : {3.0, 70.0, 5000.0}) {
      const Camera camera{{0, -distance, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
      const ScaleBar bar = scale_bar(camera, kOverlaid, meters);
      EXPECT_LE(bar.pixels, 0.2 * kOverlaid.width + 1e-9);
      EXPECT_GT(bar.pixels, 0.06 * kOverlaid.width);
      const double pixel = length_of_pixel(camera, kOverlaid, distance) * meters;
      EXPECT_NEAR(bar.meters, bar.pixels * pixel, 1e-9 * bar.meters);
      const double first = bar.meters / std::pow(10, std::floor(std::log10(bar.meters) + 1e-9));
      EXPECT_TRUE(std::abs(first - 1) < 1e-6 || std::abs(first - 2) < 1e-6 ||
                  std::abs(first - 5) < 1e-6)
          << bar.meters;
    }
  }
}

TEST(Overlay, ThereIsNoScaleFromTheSide) {
  DrawList list;
  list.captions.meters = 1;
  list.captions.north = true;
  EXPECT_FALSE(overlay_of(list, kAbove, kOverlaid).strokes.empty());
  const Camera level{{0, -50, 1}, {0, 0, 0}, {0, 0, 1}, 0.8};
  EXPECT_TRUE(overlay_of(list, level, kOverlaid).strokes.empty());
}

}  // namespace
}  // namespace soms::view
