#include "soms/base/box.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soms {
namespace {

const Box kUnit{{0, 0, 0}, {1, 1, 1}};

TEST(Box, DefaultIsEmptyAndOverlapsNothing) {
  const Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_FALSE(overlaps(box, kUnit));
  EXPECT_FALSE(overlaps(box, box));
  EXPECT_EQ(volume(box), 0);
  EXPECT_EQ(half_area(box), 0);
}

TEST(Box, GrowsByPointsAndBoxes) {
  Box box;
  box.grow(Vec3{1, -2, 3});
  EXPECT_EQ(box, (Box{{1, -2, 3}, {1, -2, 3}}));
  EXPECT_FALSE(box.empty());
  box.grow(Box{});
  EXPECT_EQ(box, (Box{{1, -2, 3}, {1, -2, 3}}));
  box.grow(kUnit);
  EXPECT_EQ(box, (Box{{0, -2, 0}, {1, 1, 3}}));
  EXPECT_EQ(box.extent(), (Vec3{1, 3, 3}));
  EXPECT_EQ(box.center(), (Vec3{0.5, -0.5, 1.5}));
  EXPECT_EQ(volume(box), 9);
  EXPECT_EQ(half_area(box), 15);
}

TEST(Box, TouchingCountsAsOverlap) {
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_TRUE(overlaps(kUnit, {{1, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(overlaps(kUnit, {{above, 1, 1}, {2, 2, 2}}));
  EXPECT_FALSE(overlaps(kUnit, {{1, above, 1}, {2, 2, 2}}));
  EXPECT_FALSE(overlaps({{1, 1, above}, {2, 2, 2}}, kUnit));
  EXPECT_TRUE(overlaps(kUnit, {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}));
}

TEST(Box, ContainsItsBoundary) {
  EXPECT_TRUE(kUnit.contains(kUnit));
  EXPECT_TRUE(kUnit.contains(Box{}));
  EXPECT_FALSE(kUnit.contains({{0, 0, 0}, {1, 1, 1.5}}));
  EXPECT_FALSE(kUnit.contains({{-0.5, 0, 0}, {1, 1, 1}}));
}

TEST(Box, BoundsOfATriangle) {
  EXPECT_EQ(bounds(Triangle{{0, 5, 2}, {1, 3, 2}, {-1, 4, 2}}), (Box{{-1, 3, 2}, {1, 5, 2}}));
}

}  // namespace
}  // namespace soms
