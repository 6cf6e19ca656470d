#include "soms/geometry/midpoint.h"

#include <gtest/gtest.h>

namespace soms {
namespace {

const Triangle kTriangle{{0, 0, 0}, {4, 0, 2}, {1, 8, -6}};

TEST(Midpoint, OfTheThesisHalvesTwice) {
  EXPECT_EQ(midpoint(kTriangle, Midpoint::thesis), (Vec3{1.5, 4, -2.5}));
  EXPECT_EQ(midpoint(kTriangle, Midpoint::thesis, 2), (Vec3{1.5, 4, -2.5}));
}

TEST(Midpoint, OfTheThesisDependsOnWhichCornerIsC) {
  EXPECT_EQ(midpoint(kTriangle, Midpoint::thesis, 0), (Vec3{1.25, 2, -1}));
  EXPECT_EQ(midpoint(kTriangle, Midpoint::thesis, 1), (Vec3{2.25, 2, -0.5}));
}

TEST(Midpoint, CentroidRoundsTheSumThenTheThird) {
  EXPECT_EQ(midpoint({{0, 0, 0}, {3, 0, 0}, {0, 6, 9}}, Midpoint::centroid), (Vec3{1, 2, 3}));
  const Vec3 big{1e16, 0, 0};
  const Vec3 one{1, 0, 0};
  // (1e16 + 1) + 1 loses both ones; 1e16 + (1 + 1) would not.
  EXPECT_EQ(midpoint({big, one, one}, Midpoint::centroid).x, 1e16 / 3);
  EXPECT_EQ(midpoint({one, one, big}, Midpoint::centroid).x, (1e16 + 2) / 3);
}

TEST(Midpoint, OfTheBoxIgnoresTheOrderOfCorners) {
  EXPECT_EQ(midpoint(kTriangle, Midpoint::aabb), (Vec3{2, 4, -2}));
  EXPECT_EQ(midpoint({kTriangle.c, kTriangle.a, kTriangle.b}, Midpoint::aabb), (Vec3{2, 4, -2}));
}

}  // namespace
}  // namespace soms
