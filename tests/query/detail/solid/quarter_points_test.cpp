#include "soms/query/detail/solid/quarter_points.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <utility>

namespace soms {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// In the planes z = 0 and x = 0: they cross along the y axis from 0 to 1.
const Triangle kLying{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
const Triangle kStanding{{0, 0, -1}, {0, 0, 1}, {0, 2, 0}};

TEST(QuarterPoints, LieInAllFourQuartersBesideTheMiddle) {
  const auto points = detail::quarter_points(kLying, kStanding);
  ASSERT_TRUE(points.has_value());
  std::set<std::pair<bool, bool>> quarters;
  for (const Vec3& p : *points) {
    quarters.emplace(p.x > 0, p.z > 0);
    EXPECT_NE(p.x, 0);
    EXPECT_NE(p.z, 0);
    EXPECT_NEAR(p.x, 0, 0.1);
    EXPECT_NEAR(p.y, 0.5, 0.1);
    EXPECT_NEAR(p.z, 0, 0.1);
  }
  EXPECT_EQ(quarters.size(), 4U);
}

TEST(QuarterPoints, ThereAreNoneWhereNothingCrosses) {
  EXPECT_FALSE(detail::quarter_points(kLying, kLying).has_value());
  const Triangle above{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
  EXPECT_FALSE(detail::quarter_points(kLying, above).has_value());
  const Triangle beside{{9, 0, -1}, {9, 0, 1}, {9, 2, 0}};
  EXPECT_FALSE(detail::quarter_points(kLying, beside).has_value());
  const Triangle flat{{0, 0, -1}, {0, 0, 1}, {0, 0, 3}};
  EXPECT_FALSE(detail::quarter_points(kLying, flat).has_value());
}

// Their products are beyond the range of doubles.
TEST(QuarterPoints, ThereAreNoneWhereDoublesEnd) {
  const auto scaled = [](const Triangle& t, double s) {
    return Triangle{s * t.a, s * t.b, s * t.c};
  };
  for (const double s : {0x1p300, 0x1p-1000, kNoNumber}) {
    EXPECT_FALSE(detail::quarter_points(scaled(kLying, s), scaled(kStanding, s)).has_value()) << s;
  }
}

}  // namespace
}  // namespace soms
