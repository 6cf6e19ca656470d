#include "soms/query/detail/winding/strip_angle.h"

#include "soms/base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace soms::detail {
namespace {

constexpr long double kFullCircle = 6.283185307179586476925286766559005768L;

/// Half the solid angle of the strip in turns, by the formula in long double; its error.
struct LongStrip {
  long double turns;
  long double error;
};

LongStrip long_strip(const Vec3& from, const Vec3& to, const Vec3& p,
                     const StripDirection& direction) {
  using Arm = std::array<long double, 3>;
  const std::size_t i = direction.axis;
  const auto arm = [&](const Vec3& v) {
    Arm a{};
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = static_cast<long double>(v[(i + k) % 3]) - p[(i + k) % 3];
    }
    a[0] *= direction.sign;
    return a;
  };
  const Arm a = arm(from);
  const Arm b = arm(to);
  const long double la = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  const long double lb = std::sqrt(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
  const long double re = (la + a[0]) * (lb + b[0]) + a[1] * b[1] + a[2] * b[2];
  const long double im = (a[1] * b[2] - a[2] * b[1]) * direction.sign;
  return {std::atan2(im, re) / kFullCircle, 32 * 0x1p-64L * la * lb / std::hypot(re, im)};
}

/// Any point, one near the line of the edge, or one that the strip passes closely.
Vec3 point_beside(Rng& rng, const Vec3& a, const Vec3& b, const StripDirection& direction) {
  Vec3 p{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
  const std::uint64_t kind = rng.below(3);
  const double off = std::exp2(rng.uniform(-20, 0));
  if (kind > 0) {
    p = (a + (b - a) * rng.uniform(-0.2, 1.2)) + p * off;
  }
  if (kind == 2) {
    p[direction.axis] += direction.sign * rng.uniform(0, 2);
  }
  return p;
}

TEST(StripAngle, IsWithinItsError) {
  Rng rng(11);
  int close = 0;
  for (int i = 0; i < 300'000; ++i) {
    const Vec3 a{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Vec3 b{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const StripDirection direction{rng.below(3), rng.below(2) == 0 ? 1.0 : -1.0};
    const Vec3 p = point_beside(rng, a, b, direction);
    const LongStrip truth = long_strip(a, b, p, direction);
    if (truth.error > 1e-14L || std::abs(truth.turns) > 0.4999999L) {
      continue;
    }
    const StripAngle z =
        strip_angle(a, seen_corner(a, p, direction), b, seen_corner(b, p, direction), p, direction);
    ASSERT_LE(z.error, 0.5);
    const long double turns =
        std::atan2(static_cast<long double>(z.im), static_cast<long double>(z.re)) / kFullCircle;
    ASSERT_LE(std::abs(turns - truth.turns), z.error + truth.error);
    close += std::hypot(z.re, z.im) < 0x1p-10 ? 1 : 0;
  }
  EXPECT_GT(close, 300);
}

// Of a point on the strip the angle is half a turn, either way; the sign is that of a point beside.
TEST(StripAngle, JumpsAsTheRayPassesTheEdge) {
  const Vec3 a{-1, 0, 1};
  const Vec3 b{1, 0, 1};
  for (const double sign : {1.0, -1.0}) {
    const StripDirection up{2, sign};
    const auto turns = [&](double x, double y) {
      const Vec3 p{x, y, 1 + 2 * sign};
      const StripAngle z = strip_angle(a, seen_corner(a, p, up), b, seen_corner(b, p, up), p, up);
      return std::atan2(z.im, z.re);
    };
    const double on = turns(0, 0);
    EXPECT_NEAR(std::abs(on), std::atan2(0, -1), 0.5);
    // The point moves by e and e^2 on x and y.
    EXPECT_EQ(on > 0, turns(0, 1e-12) > 0);
    EXPECT_NE(on > 0, turns(0, -1e-12) > 0);
    EXPECT_EQ(turns(0.25, 0) > 0, on > 0);
  }
}

TEST(StripAngle, KnowsCornersOnTheLineOfTheStrip) {
  const StripDirection up{2, 1};
  const Vec3 p{0, 0, 5};
  const SeenCorner below = seen_corner({0, 0, 1}, p, up);
  EXPECT_EQ(below.along, 0);
  EXPECT_EQ(std::hypot(below.first, below.second), 1);
  const SeenCorner above = seen_corner({0, 0, 9}, p, up);
  EXPECT_EQ(above.along, 1);
  EXPECT_EQ(seen_corner(p, p, up).along, 0);
}

TEST(StripAngle, OfTheLeastNumbersIsThatOfUsualOnes) {
  for (const double unit : {0x1p-1070, 0x1p-500, 0x1p290}) {
    const StripDirection up{2, 1};
    const Vec3 a{-unit, unit, 3 * unit};
    const SeenCorner seen = seen_corner(a, {0, 0, 0}, up);
    const SeenCorner usual = seen_corner({-1, 1, 3}, {0, 0, 0}, up);
    EXPECT_NEAR(seen.along, usual.along, 1e-15);
    EXPECT_NEAR(seen.second, usual.second, 1e-15);
    const SeenCorner down = seen_corner(a, {0, 0, 5 * unit}, up);
    EXPECT_NEAR(down.first, seen_corner({-1, 1, 3}, {0, 0, 5}, up).first, 1e-15);
  }
  for (const double thin : {0x1p-1074, 0x1p-520, 0x1p-500, 0x1p-300, 0x1p-105}) {
    for (const double far : {0x1p-450, 0x1p-390, 1.0, 0x1p300}) {
      if (thin < far * 0x1p-80) {
        const SeenCorner seen = seen_corner({thin, -thin, 0}, {0, 0, far}, {2, 1});
        EXPECT_NEAR(seen.first, std::sqrt(0.5), 1e-15);
        EXPECT_NEAR(seen.second, -std::sqrt(0.5), 1e-15);
        EXPECT_NEAR(seen.along, 0, 0x1p-79);
      }
    }
  }
}

}  // namespace
}  // namespace soms::detail
