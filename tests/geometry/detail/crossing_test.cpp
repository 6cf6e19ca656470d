#include "soms/geometry/detail/crossing.h"

#include "soms/base/random.h"
#include "soms/geometry/detail/exact/leading_part.h"
#include "soms/geometry/detail/parts/common_corners.h"
#include "soms/geometry/triangle_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace soms::detail {
namespace {

long double ratio_of(const Share& share) {
  const LeadingPart above = leading_part(share.part);
  const LeadingPart below = leading_part(share.whole);
  const DoubleDouble q = above.value / below.value;
  return std::ldexp(static_cast<long double>(q.high) + static_cast<long double>(q.low),
                    above.exponent - below.exponent);
}

/// The mean of the corners of what the triangles share, from whole numbers.
Vec3 exact_middle(const Triangle& a, const Triangle& b) {
  const std::vector<CommonCorner> corners = common_corners(ExactPair(a, b), {}, std::nullopt);
  Vec3 middle;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    long double sum = 0;
    for (const CommonCorner& c : corners) {
      const bool on_a = c.on_a.whole.sign() != 0;
      const Share& share = on_a ? c.on_a : c.on_b;
      const Triangle& t = on_a ? a : b;
      const long double begin = corner(t, share.begin)[axis];
      const long double end = corner(t, share.end)[axis];
      sum += begin + ratio_of(share) * (end - begin);
    }
    middle[axis] = static_cast<double>(sum / static_cast<long double>(corners.size()));
  }
  return middle;
}

Triangle random_triangle(Rng& rng, double size, const Vec3& at) {
  const auto point = [&] {
    return at +
           Vec3{size * rng.uniform(-1, 1), size * rng.uniform(-1, 1), size * rng.uniform(-1, 1)};
  };
  return {point(), point(), point()};
}

double largest(const Triangle& a, const Triangle& b) {
  double most = 0;
  for (const Triangle* t : {&a, &b}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        most = std::max(most, std::abs(corner(*t, i)[axis]));
      }
    }
  }
  return most;
}

TEST(CrossingMiddle, IsThatOfWholeNumbers) {
  Rng rng(7);
  std::size_t crossing = 0;
  std::size_t found = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double size = std::exp2(rng.uniform(-60, 60));
    const Vec3 at = (i % 3 == 0   ? 1e6
                     : i % 3 == 1 ? 1.0
                                  : 0.0) *
                    size * Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const double other = i % 2 == 0 ? 1 : std::exp2(rng.uniform(-12, 0));
    const Triangle a = random_triangle(rng, size, at);
    const Triangle b = random_triangle(rng, size * other, at);
    const std::optional<Vec3> middle = crossing_middle(a, b);
    const bool overlap = triangles_overlap(a, b);
    crossing += overlap ? 1U : 0U;
    if (!middle) {
      continue;
    }
    ++found;
    ASSERT_TRUE(overlap) << i;
    const Vec3 exact = exact_middle(a, b);
    const double bound = 2 * 0x1p-53 * largest(a, b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR((*middle)[axis], exact[axis], bound) << i;
    }
  }
  EXPECT_GT(crossing, 1000U);
  EXPECT_GT(found, crossing * 99 / 100);
}

TEST(CrossingMiddle, IsLeftToWholeNumbersWhereSidesAreNotSure) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const auto none = [&](const Triangle& t) {
    return !crossing_middle(flat, t) && !crossing_middle(t, flat);
  };
  EXPECT_TRUE(none({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}));           // in one plane
  EXPECT_TRUE(none({{1, 1, 0}, {1, 2, 1}, {2, 1, 1}}));           // a corner on the face
  EXPECT_TRUE(none({{-1, 0, -1}, {5, 0, -1}, {1, 0, 1}}));        // through an edge
  EXPECT_TRUE(none({{1, 1, 1}, {1, 2, 1}, {2, 1, 1}}));           // on one side
  EXPECT_TRUE(none({{5, 5, -1}, {5, 6, 1}, {6, 5, 1}}));          // through the plane, but beside
  EXPECT_TRUE(none({{1, 1, -1}, {1, 1, 1}, {1, 1, 1}}));          // no area
  EXPECT_TRUE(none({{1, 1, -1}, {1, 1, 0x1p-60}, {1.5, 1, 1}}));  // nearly on the face
  EXPECT_FALSE(none({{1, 1, -1}, {1, 2, 1}, {2, 1, 1}}));
}

}  // namespace
}  // namespace soms::detail
