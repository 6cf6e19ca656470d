#include "apps/draw/canvas.h"

#include <gtest/gtest.h>

namespace soms::look {
namespace {

constexpr Size kSize{60, 60};
constexpr Rgb kWhitePaper = rgb(0xffffff);
constexpr Rgb kBlueBody = rgb(0x0000ff);
constexpr Rgb kRedBody = rgb(0xff0000);

/// Looks along +y from (0, -10, 0): at y = 0 the picture shows x and z from -10 to 10.
Canvas canvas_at_origin() {
  return Canvas(kSize, {{0, -10, 0}, frame_along({0, 1, 0}, {0, 0, 1}), 1}, kWhitePaper);
}

/// A triangle upright at y that covers the middle of the picture, and no corner of it.
Triangle upright(double y, double size = 1) {
  return {{-4 * size, y, -4 * size}, {4 * size, y, -4 * size}, {0, y, 6 * size}};
}

Color middle_of(const Canvas& canvas) {
  return canvas.picture().at(30, 30);
}

TEST(Canvas, PaintsATriangleOnPaper) {
  Canvas canvas = canvas_at_origin();
  canvas.draw(upright(0), 0.1, {.color = kBlueBody});
  const Picture picture = canvas.picture();
  EXPECT_EQ(picture.size, kSize);
  EXPECT_EQ(picture.at(1, 1), color_of(kWhitePaper));
  EXPECT_GT(picture.at(30, 30).b, 140);
  EXPECT_EQ(picture.at(30, 30).r, 0);
}

TEST(Canvas, TheNearerHidesTheFarther) {
  for (const bool far_first : {true, false}) {
    Canvas canvas = canvas_at_origin();
    canvas.draw(upright(far_first ? 3 : 0), 0.1, {.color = far_first ? kRedBody : kBlueBody});
    canvas.draw(upright(far_first ? 0 : 3), 0.1, {.color = far_first ? kBlueBody : kRedBody});
    EXPECT_EQ(middle_of(canvas).r, 0) << far_first;
    EXPECT_GT(middle_of(canvas).b, 140) << far_first;
  }
}

TEST(Canvas, OneSeesThroughGlassAndWhatIsAround) {
  Canvas glass = canvas_at_origin();
  glass.draw(upright(3), 0.1, {kRedBody, 1, CanvasLayer::solid});
  glass.draw(upright(0), 0.1, {kBlueBody, 2, CanvasLayer::glass});
  EXPECT_GT(middle_of(glass).r, 60);
  EXPECT_GT(middle_of(glass).b, 40);
  Canvas around = canvas_at_origin();
  around.draw(upright(3), 0.1, {kRedBody, 1, CanvasLayer::solid});
  around.draw(upright(0), 0.1, {kBlueBody, 3, CanvasLayer::around});
  EXPECT_GT(middle_of(around).r, 60);
  EXPECT_GT(middle_of(around).b, 40);
  Canvas behind = canvas_at_origin();
  behind.draw(upright(0), 0.1, {kRedBody, 1, CanvasLayer::solid});
  behind.draw(upright(3), 0.1, {kBlueBody, 2, CanvasLayer::glass});
  EXPECT_EQ(middle_of(behind).b, 0);
}

TEST(Canvas, WhatIsNearerThanTheCutIsLeftOut) {
  Canvas canvas = canvas_at_origin();
  canvas.draw(upright(0), 10.5, {.color = kBlueBody});
  EXPECT_EQ(middle_of(canvas), color_of(kWhitePaper));
  // A plate from before the eye to far behind the cut: only its far part is drawn.
  canvas.draw({{-90, -30, -5}, {90, -30, -5}, {0, 60, -5}}, 10.5, {.color = kBlueBody});
  const Picture picture = canvas.picture();
  EXPECT_EQ(picture.at(30, 59), color_of(kWhitePaper)) << "nearer than 10.5";
  EXPECT_GT(picture.at(30, 40).b, picture.at(30, 40).r + 60);
}

TEST(Canvas, MarksAreInFrontOfAll) {
  Canvas canvas = canvas_at_origin();
  canvas.draw(upright(0), 0.1, {.color = kBlueBody});
  canvas.mark({0, 5, 0}, 4, kRedBody, kWhitePaper);
  canvas.mark({0, -20, 0}, 20, kBlueBody, kWhitePaper);  // behind the eye
  const Picture picture = canvas.picture();
  EXPECT_EQ(picture.at(30, 30), color_of(kRedBody));
  EXPECT_EQ(picture.at(34, 30), color_of(kWhitePaper));
}

TEST(Canvas, LinesAreBetweenObjectsAndAroundThem) {
  Canvas canvas = canvas_at_origin();
  canvas.draw({{-8, 0, -8}, {0, 0, -8}, {0, 0, 8}}, 0.1, {.color = kBlueBody, .object = 3});
  canvas.draw({{8, 0, -8}, {0, 0, -8}, {0, 0, 8}}, 0.1, {.color = kBlueBody, .object = 4});
  const Picture two = canvas.picture();
  EXPECT_LT(two.at(29, 40).b + 20, two.at(25, 40).b) << "a line between them";
  EXPECT_EQ(two.at(25, 40), two.at(35, 40));
}

}  // namespace
}  // namespace soms::look
