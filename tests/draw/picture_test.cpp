#include "apps/draw/picture.h"

#include <gtest/gtest.h>

#include <array>

namespace soms::look {
namespace {

TEST(PictureColors, MixFromOneToTheOther) {
  const Color dark{10, 0, 200, 77};
  const Color pale{20, 255, 100, 255};
  EXPECT_EQ(mixed(dark, pale, 0), dark);
  EXPECT_EQ(mixed(dark, pale, 1), (Color{20, 255, 100, 77}));
  EXPECT_EQ(mixed(dark, pale, 0.5), (Color{15, 128, 150, 77}));
}

TEST(PictureColors, LightIsFromBlackToWhite) {
  const Color sand{200, 100, 50, 255};
  EXPECT_EQ(lit(sand, 0), (Color{0, 0, 0, 255}));
  EXPECT_EQ(lit(sand, 0.5), (Color{100, 50, 25, 255}));
  EXPECT_EQ(lit(sand, 1), sand);
  EXPECT_EQ(lit(sand, 2), (Color{255, 200, 100, 255}));
}

TEST(PictureColors, AMeanIsRoundedUpFromHalf) {
  const std::array two{Color{0, 1, 255, 0}, Color{1, 1, 255, 255}};
  EXPECT_EQ(mean_of(two), (Color{1, 1, 255, 255}));
  EXPECT_EQ(mean_of(std::array{Color{7, 8, 9, 255}}), (Color{7, 8, 9, 255}));
}

TEST(PictureColors, APixelIsWhereItWasPut) {
  Picture picture = filled({3, 2}, {1, 2, 3, 255});
  picture.put(2, 1, {9, 8, 7, 6});
  EXPECT_EQ(picture.at(2, 1), (Color{9, 8, 7, 6}));
  EXPECT_EQ(picture.at(1, 1), (Color{1, 2, 3, 255}));
  EXPECT_EQ(picture.bytes.size(), 24U);
  EXPECT_EQ(picture.bytes[20], 9);
}

}  // namespace
}  // namespace soms::look
