#include "apps/draw/picture_marks.h"

#include <gtest/gtest.h>

namespace soms::look {
namespace {

constexpr Color kWhite{255, 255, 255, 255};
constexpr Color kBlack{0, 0, 0, 255};

TEST(PictureMarks, ADiscHasItsArea) {
  Picture picture = filled({40, 40}, kWhite);
  draw_disc(picture, {20, 20}, 10, kBlack);
  double dark = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      dark += (255 - picture.at(x, y).r) / 255.0;
    }
  }
  EXPECT_NEAR(dark, 314.159, 3);
  EXPECT_EQ(picture.at(20, 20), kBlack);
  EXPECT_EQ(picture.at(2, 2), kWhite);
}

TEST(PictureMarks, AMarkHasAHalo) {
  Picture picture = filled({40, 40}, {90, 90, 90, 255});
  draw_mark(picture, {20.5, 20.5}, 6, kBlack, kWhite);
  EXPECT_EQ(picture.at(20, 20), kBlack);
  EXPECT_EQ(picture.at(24, 20), kBlack);
  EXPECT_EQ(picture.at(27, 20), kWhite);
  EXPECT_EQ(picture.at(31, 20), (Color{90, 90, 90, 255}));
}

TEST(PictureMarks, WhatLiesOutsideIsLeftOut) {
  Picture picture = filled({8, 8}, kWhite);
  draw_disc(picture, {-50, 4}, 3, kBlack);
  draw_line(picture, {20, 20}, {90, 400}, 2, kBlack);
  EXPECT_EQ(picture, filled({8, 8}, kWhite));
  draw_line(picture, {-100, 4}, {100, 4}, 4, kBlack);
  EXPECT_EQ(picture.at(0, 4), kBlack);
  EXPECT_EQ(picture.at(7, 3), kBlack);
  EXPECT_EQ(picture.at(4, 0), kWhite);
}

TEST(PictureMarks, TranslucentColorsLetThrough) {
  Picture picture = filled({4, 4}, kWhite);
  draw_rectangle(picture, {4, 4}, {0, 0}, with_alpha(kBlack, 51));
  EXPECT_EQ(picture, filled({4, 4}, {204, 204, 204, 255}));
}

TEST(PictureMarks, NumbersStandOnTheirLine) {
  Picture picture = filled({60, 30}, kWhite);
  draw_number(picture, {5, 20}, "10", 12, kBlack);
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
}  // namespace soms::look
