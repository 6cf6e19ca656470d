#include "apps/view/drawing/picture_marks.h"

#include "apps/view/drawing/palette.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

TEST(PictureMarks, ADiscHasItsArea) {
  Picture picture = filled({40, 40}, palette::kPaper);
  draw_disc(picture, {20, 20}, 10, palette::kBlack);
  double dark = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      dark += (255 - picture.at(x, y).r) / 255.0;
    }
  }
  EXPECT_NEAR(dark, 314.159, 3);
  EXPECT_EQ(picture.at(20, 20), palette::kBlack);
  EXPECT_EQ(picture.at(2, 2), palette::kPaper);
}

TEST(PictureMarks, WhatLiesOutsideIsLeftOut) {
  Picture picture = filled({8, 8}, palette::kPaper);
  draw_disc(picture, {-50, 4}, 3, palette::kBlack);
  draw_line(picture, {20, 20}, {90, 400}, 2, palette::kBlack);
  EXPECT_EQ(picture, filled({8, 8}, palette::kPaper));
  draw_line(picture, {-100, 4}, {100, 4}, 4, palette::kBlack);
  EXPECT_EQ(picture.at(0, 4), palette::kBlack);
  EXPECT_EQ(picture.at(7, 3), palette::kBlack);
  EXPECT_EQ(picture.at(4, 0), palette::kPaper);
}

TEST(PictureMarks, TranslucentColorsLetThrough) {
  Picture picture = filled({4, 4}, palette::kPaper);
  draw_rectangle(picture, {4, 4}, {0, 0}, with_alpha(palette::kBlack, 51));
  EXPECT_EQ(picture, filled({4, 4}, {204, 204, 204, 255}));
}

TEST(PictureMarks, NumbersStandOnTheirLine) {
  Picture picture = filled({60, 30}, palette::kPaper);
  draw_number(picture, {5, 20}, "10", 12, palette::kBlack);
  int above = 0;
  int below = 0;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 60; ++x) {
      (y <= 21 && y >= 7 ? above : below) += picture.at(x, y).r < 128 ? 1 : 0;
    }
  }
  EXPECT_GT(above, 30);
  EXPECT_EQ(below, 0);
}

}  // namespace
}  // namespace soms::view
