#include "soms/base/vector.h"

#include <gtest/gtest.h>

#include <limits>

namespace soms {
namespace {

TEST(Vector, IsIndexedByAxis) {
  Vec3 v{1, 2, 3};
  EXPECT_EQ(v[0], 1);
  EXPECT_EQ(v[1], 2);
  EXPECT_EQ(v[2], 3);
  v[1] = 7;
  EXPECT_EQ(v, (Vec3{1, 7, 3}));
}

TEST(Vector, ComparesAsNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ((Vec3{-0.0, 0, 0}), (Vec3{0, -0.0, 0}));
  EXPECT_FALSE((Vec3{nan, 0, 0}) == (Vec3{nan, 0, 0}));
}

TEST(Vector, AddsScalesAndMultiplies) {
  const Vec3 u{1, 2, 3};
  const Vec3 v{4, 5, 6};
  EXPECT_EQ(u + v, (Vec3{5, 7, 9}));
  EXPECT_EQ(v - u, (Vec3{3, 3, 3}));
  EXPECT_EQ(2 * u, (Vec3{2, 4, 6}));
  EXPECT_EQ(-u, (Vec3{-1, -2, -3}));
  EXPECT_EQ(dot(u, v), 32);
  EXPECT_EQ(cross(u, v), (Vec3{-3, 6, -3}));
}

}  // namespace
}  // namespace soms
