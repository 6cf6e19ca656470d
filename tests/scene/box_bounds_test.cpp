// Bounds of boxes, against points of them that are known exactly.
#include "soms/scene/detail/box_bounds.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using detail::distance_at_least;
using detail::entry_at_least;
using detail::kNoEntry;

TEST(BoxBounds, GapsAlongAnAxisAreDistances) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(distance_at_least(Vec3{0.5, 0, 1}, box), 0);
  for (const double gap : {1e-100, 1e-3, 1.0, 3.0, 1e80}) {
    const double bound = distance_at_least(Vec3{1 + gap, 0.5, 0.5}, box);
    EXPECT_LE(bound, (1 + gap) - 1);
    EXPECT_GE(bound, ((1 + gap) - 1) * (1 - 1e-14));
  }
}

// Nothing is gained below 2^-530, and nothing is claimed: the square of such a gap may round up.
TEST(BoxBounds, SmallestGapsAreNotExceeded) {
  const Box box{{0, 0, 0}, {0, 0, 0}};
  for (int exponent = -1074; exponent <= -400; ++exponent) {
    for (const double digits : {1.0, 1.3, 1.45, 1.99}) {
      const double gap = std::ldexp(digits, exponent);
      ASSERT_LE(distance_at_least(Vec3{gap, 0, 0}, box), gap) << exponent;
      ASSERT_LE(distance_at_least(Vec3{-gap, 0, 0}, box), gap) << exponent;
    }
  }
}

// Pythagorean quadruples: the distance is a double, and rounding must not exceed it.
TEST(BoxBounds, DistancesAreNotExceeded) {
  test::for_each_case("scene/box-bounds/points", 2000, [](Rng& rng) {
    const auto m = static_cast<double>(rng.below(1000));
    const auto n = static_cast<double>(rng.below(1000));
    const auto p = static_cast<double>(rng.below(1000));
    const auto q = static_cast<double>(rng.below(1000));
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(600)) - 300);
    const Vec3 gap =
        Vec3{m * m + n * n - p * p - q * q, 2 * (m * q + n * p), 2 * (n * q - m * p)} * scale;
    const double length = (m * m + n * n + p * p + q * q) * scale;
    const Box box{{0, 0, 0}, {0, 0, 0}};
    const double bound = distance_at_least(gap, box);
    ASSERT_LE(bound, length);
    ASSERT_GE(bound, length * (1 - 1e-14));
  });
}

// No point of one box is nearer to a point of the other.
TEST(BoxBounds, DistancesOfBoxesAreThoseOfTheirPoints) {
  test::for_each_case("scene/box-bounds/boxes", 2000, [](Rng& rng) {
    const auto number = [&] { return static_cast<double>(rng.below(9)) - 4; };
    Box a;
    Box b;
    for (int k = 0; k < 2; ++k) {
      a.grow(Vec3{number(), number(), number()});
      b.grow(Vec3{number(), number(), number()});
    }
    const double bound = distance_at_least(a, b);
    ASSERT_EQ(bound, distance_at_least(b, a));
    ASSERT_EQ(bound == 0, overlaps(a, b));
    Vec3 nearest;  // in b, to the point of a that is nearest to it
    Vec3 other;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      nearest[axis] = std::clamp(a.lower[axis], b.lower[axis], b.upper[axis]);
      other[axis] = std::clamp(nearest[axis], a.lower[axis], a.upper[axis]);
      nearest[axis] = std::clamp(other[axis], b.lower[axis], b.upper[axis]);
    }
    const Vec3 gap = other - nearest;
    const double length = std::sqrt(gap.x * gap.x + gap.y * gap.y + gap.z * gap.z);
    ASSERT_LE(bound, length);
    ASSERT_GE(bound, length * (1 - 1e-14));
  });
}

TEST(BoxBounds, RaysEnterWhereTheyMeetTheBox) {
  const Box box{{1, -1, -1}, {3, 1, 1}};
  EXPECT_NEAR(entry_at_least({0, 0, 0}, {2, 0, 0}, box), 0.5, 1e-14);
  EXPECT_EQ(entry_at_least({2, 0, 0}, {2, 0, 0}, box), 0);
  EXPECT_EQ(entry_at_least({0, 0, 0}, {-1, 0, 0}, box), kNoEntry);
  EXPECT_EQ(entry_at_least({0, 2, 0}, {1, 0, 0}, box), kNoEntry);
  EXPECT_LE(entry_at_least({0, 1, -1}, {1, -0.0, 0}, box), 1);  // in a face and in an edge
  EXPECT_LE(entry_at_least({0, 2, 0}, {1, -1, 0}, box), 1);     // through an edge
  EXPECT_EQ(entry_at_least({2, 0, 0}, {0, 0, 0}, box), 0);      // a point
  EXPECT_EQ(entry_at_least({0, 0, 0}, {0, 0, 0}, box), kNoEntry);
}

// A ray through a point of the box with t known exactly, scaled to the ends of the range.
TEST(BoxBounds, EntriesAreNotExceeded) {
  test::for_each_case("scene/box-bounds/rays", 3000, [](Rng& rng) {
    const auto number = [&](std::uint64_t most) {
      return static_cast<double>(rng.below(2 * most + 1)) - static_cast<double>(most);
    };
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(1200)) - 900);
    const double stretch = std::ldexp(1.0, static_cast<int>(rng.below(1200)) - 600);
    const Vec3 direction{number(1U << 20), number(1U << 20), number(3)};
    const Vec3 origin{number(1U << 20), number(1U << 20), number(1U << 20)};
    const double t = static_cast<double>(rng.below(1U << 20));
    const Vec3 at = origin + direction * t;  // exact: below 2^53
    Box box;
    box.grow(at);
    for (int k = 0; k < 3 && rng.below(2) == 0; ++k) {
      box.grow(at + Vec3{number(5), number(5), number(5)});
    }
    const Box scaled{box.lower * scale, box.upper * scale};
    const Vec3 way = direction * stretch;
    if (!(std::abs(t * scale / stretch) < 1e300)) {
      return;
    }
    const double bound = entry_at_least(origin * scale, way, scaled);
    ASSERT_LE(bound, t * scale / stretch);
    ASSERT_GE(bound, 0);
  });
}

// t is a / b on two axes, rounded once on one of them and twice on the other.
TEST(BoxBounds, RaysThroughCornersAreNotLost) {
  test::for_each_case("scene/box-bounds/corners", 3000, [](Rng& rng) {
    const auto odd = [&](std::uint64_t below) { return 2 * rng.below(below / 2) + 1; };
    const std::uint64_t a = odd(1U << 30);
    const std::uint64_t b = odd(1U << 10);
    const std::uint64_t s = odd(1U << 30);
    const std::uint64_t low = a * s % (1U << 30);
    const double sign = rng.below(2) == 0 ? 1 : -1;
    const Vec3 origin = Vec3{-static_cast<double>(a * s - low), 0, 1} * sign;
    const Vec3 direction =
        Vec3{static_cast<double>(b) * static_cast<double>(s), static_cast<double>(b), 0} * sign;
    Box box;
    box.grow(Vec3{static_cast<double>(low), static_cast<double>(a), 1} * sign);
    const double bound = entry_at_least(origin, direction, box);
    ASSERT_LE(static_cast<long double>(bound) * static_cast<long double>(b),
              static_cast<long double>(a));
    ASSERT_GE(bound, static_cast<double>(a) / static_cast<double>(b) * (1 - 1e-14));
  });
}

}  // namespace
}  // namespace soms
