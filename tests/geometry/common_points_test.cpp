#include "soms/geometry/common_points.h"

#include "soms/base/box.h"
#include "soms/base/random.h"
#include "soms/geometry/triangle_overlap.h"

#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace soms {
namespace {

/// A vector of extended precision: the twin that corners are measured by.
struct Wide {
  long double x, y, z;
};

Wide operator-(const Wide& a, const Wide& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

Wide along(const Wide& a, const Wide& d, long double s) {
  return {a.x + d.x * s, a.y + d.y * s, a.z + d.z * s};
}

long double dot(const Wide& a, const Wide& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Wide cross(const Wide& a, const Wide& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Wide wide(const Vec3& v) {
  return {v.x, v.y, v.z};
}

long double length(const Wide& v) {
  return std::sqrt(dot(v, v));
}

long double to_segment(const Wide& p, const Wide& a, const Wide& b) {
  const Wide d = b - a;
  const long double square = dot(d, d);
  const long double s = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0L, 1.0L) : 0.0L;
  return length(p - along(a, d, s));
}

/// Distance of a point from a triangle.
long double to_triangle(const Vec3& point, const Triangle& t) {
  const Wide p = wide(point);
  const Wide a = wide(t.a);
  const Wide b = wide(t.b);
  const Wide c = wide(t.c);
  long double best =
      std::min(to_segment(p, a, b), std::min(to_segment(p, b, c), to_segment(p, c, a)));
  const Wide n = cross(b - a, c - a);
  const long double square = dot(n, n);
  const auto within = [&](const Wide& from, const Wide& to) {
    return dot(cross(to - from, p - from), n) >= 0;
  };
  if (square > 0 && within(a, b) && within(b, c) && within(c, a)) {
    best = std::min(best, std::abs(dot(n, p - a)) / std::sqrt(square));
  }
  return best;
}

/// Distance of a point from a crossing.
long double to_crossing(const Vec3& point, const CommonPoints& crossing) {
  const auto p = crossing.points();
  long double best = std::numeric_limits<long double>::infinity();
  for (std::size_t i = 0; i < p.size(); ++i) {
    best = std::min(best, to_segment(wide(point), wide(p[i]), wide(p[(i + 1) % p.size()])));
  }
  for (std::size_t i = 2; i < p.size(); ++i) {
    best = std::min(best, to_triangle(point, {p[0], p[i - 1], p[i]}));
    best = std::min(best, to_triangle(point, {p[0], p[i], p[i - 1]}));
  }
  return best;
}

/// What the header promises: 1e-12 of the extent and two roundings of a coordinate.
double tolerance(const Triangle& s, const Triangle& t) {
  Box box = bounds(s);
  box.grow(bounds(t));
  const Vec3 e = box.extent();
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    most = std::max({most, std::abs(box.lower[k]), std::abs(box.upper[k])});
  }
  return 1e-12 * std::max({e.x, e.y, e.z}) + 8 * std::numeric_limits<double>::epsilon() * most;
}

/// Where an edge meets a triangle, by formulas of its own; nothing near a parallel position.
std::optional<Vec3> meet(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Wide n = cross(wide(t.b) - wide(t.a), wide(t.c) - wide(t.a));
  const Wide d = wide(q) - wide(p);
  const long double slope = dot(n, d);
  if (std::abs(slope) <= 1e-4L * length(n) * length(d)) {
    return std::nullopt;
  }
  const long double s = dot(n, wide(t.a) - wide(p)) / slope;
  const Wide at = along(wide(p), d, s);
  const Vec3 point{static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)};
  if (s < 0 || s > 1 || to_triangle(point, t) > 1e-14L) {
    return std::nullopt;
  }
  return point;
}

void expect_sound(const Triangle& s, const Triangle& t, std::size_t& touching) {
  const CommonPoints found = common_points(s, t);
  touching += found.empty() ? 0U : 1U;
  ASSERT_EQ(!found.empty(), triangles_overlap(s, t));
  const double near = tolerance(s, t);
  for (const Vec3& p : found.points()) {
    ASSERT_LE(to_triangle(p, s), near);
    ASSERT_LE(to_triangle(p, t), near);
  }
}

/// Every point where an edge of one meets the other belongs to the crossing.
void expect_whole(const Triangle& s, const Triangle& t) {
  const CommonPoints found = common_points(s, t);
  for (const auto& [of, other] : {std::pair(s, t), std::pair(t, s)}) {
    for (const auto& [p, q] :
         {std::pair(of.a, of.b), std::pair(of.b, of.c), std::pair(of.c, of.a)}) {
      if (const auto point = meet(p, q, other)) {
        ASSERT_LE(to_crossing(*point, found), 1e-9L);
      }
    }
  }
}

constexpr Triangle kFlat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(CrossingSegment, GivesTheSegmentOfACrossing) {
  const CommonPoints found = common_points(kFlat, {{1, 1, -1}, {1, 1, 1}, {2, 1, 1}});
  ASSERT_EQ(found.count, 2U);
  const Vec3 first = std::min(found.corners[0].x, found.corners[1].x) == found.corners[0].x
                         ? found.corners[0]
                         : found.corners[1];
  const Vec3 last = first == found.corners[0] ? found.corners[1] : found.corners[0];
  EXPECT_EQ(first, (Vec3{1, 1, 0}));
  EXPECT_EQ(last, (Vec3{1.5, 1, 0}));
}

TEST(CrossingSegment, GivesThePointOfATouch) {
  const CommonPoints corner = common_points(kFlat, {{1, 1, 0}, {1, 1, 1}, {2, 1, 1}});
  ASSERT_EQ(corner.count, 1U);
  EXPECT_EQ(corner.corners[0], (Vec3{1, 1, 0}));
  const CommonPoints edges = common_points(kFlat, {{2, -1, -1}, {2, 1, 1}, {9, -8, 8}});
  ASSERT_EQ(edges.count, 1U);
  EXPECT_EQ(edges.corners[0], (Vec3{2, 0, 0}));
}

TEST(CrossingSegment, GivesTheSegmentThatEdgesShare) {
  const CommonPoints found = common_points(kFlat, {{1, 0, 0}, {3, 0, 0}, {2, -1, 5}});
  ASSERT_EQ(found.count, 2U);
  EXPECT_EQ(std::abs(found.corners[1].x - found.corners[0].x), 2);
}

TEST(CrossingSegment, GivesTheOutlineOfACommonArea) {
  const CommonPoints star =
      common_points({{0, 0, 5}, {6, 0, 5}, {3, 6, 5}}, {{0, 4, 5}, {3, -2, 5}, {6, 4, 5}});
  EXPECT_EQ(star.count, 6U);
  double area = 0;
  for (std::size_t i = 1; i + 1 < star.count; ++i) {
    area += 0.5 * cross(star.corners[i] - star.corners[0], star.corners[i + 1] - star.corners[0]).z;
  }
  EXPECT_NEAR(std::abs(area), 12, 1e-12);
  EXPECT_EQ(common_points(kFlat, kFlat).count, 3U);
  EXPECT_EQ(common_points(kFlat, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}).count, 3U);
}

TEST(CrossingSegment, TakesTrianglesWithoutAreaAsSegmentsAndPoints) {
  const Triangle upright{{1, 1, -1}, {1, 1, 1}, {1, 1, 0}};
  const Triangle flat{{-1, 1, 0}, {9, 1, 0}, {1, 1, 0}};
  const Triangle point{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}};
  for (const auto& [s, t] :
       {std::pair(kFlat, upright), std::pair(kFlat, point), std::pair(upright, flat),
        std::pair(point, upright), std::pair(point, point)}) {
    ASSERT_EQ(common_points(s, t).count, 1U);
    EXPECT_EQ(common_points(s, t).corners[0], (Vec3{1, 1, 0}));
  }
  const CommonPoints within = common_points(kFlat, flat);
  ASSERT_EQ(within.count, 2U);
  EXPECT_EQ(std::abs(within.corners[1].x - within.corners[0].x), 3);
  EXPECT_EQ(common_points(flat, {{3, 1, 0}, {20, 1, 0}, {4, 1, 0}}).count, 2U);
}

TEST(CrossingSegment, IsEmptyExactlyWhereTrianglesAreApart) {
  EXPECT_TRUE(common_points(kFlat, {{1, 1, 0x1p-60}, {1, 1, 1}, {2, 1, 1}}).empty());
  EXPECT_FALSE(common_points(kFlat, {{1, 1, -0x1p-60}, {1, 1, 1}, {2, 1, 1}}).empty());
}

TEST(CrossingSegment, ServesTheLargestAndSmallestCoordinates) {
  for (const double scale : {0x1p298, 0x1p-1000}) {
    const auto scaled = [scale](const Triangle& t) {
      return Triangle{t.a * scale, t.b * scale, t.c * scale};
    };
    const CommonPoints found =
        common_points(scaled(kFlat), scaled({{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}));
    ASSERT_EQ(found.count, 2U);
    EXPECT_EQ(std::abs(found.corners[1].x - found.corners[0].x), 0.5 * scale);
    EXPECT_EQ(common_points(scaled(kFlat), scaled({{1, 1, 0}, {2, 1, 0}, {1, 2, 0}})).count, 3U);
  }
  const double high = 0x1p299;
  const CommonPoints flat = common_points({{0, 0, high}, {0x1p-700, 0, high}, {0, 0x1p-700, high}},
                                          {{0, 0, high}, {0x1p-700, 0, high}, {0, 0x1p-701, high}});
  EXPECT_EQ(flat.count, 1U);  // two roundings of the height are far more than the extent
}

// Corners are off the other's plane by a part in 10^46: heights that twice a double's digits lose.
TEST(CrossingSegment, FindsWherePlanesCrossThatNearlyCoincide) {
  const Vec3 b{588879730009512, -666649603348120, -3012601983163};
  const Vec3 c{712248242444962, -305903550322659, 627970457113925};
  const Vec3 above{-283895543972275, 239486181379679, -101924113110875};
  for (const double scale : {1.0, 0x1p200, 0x1p-1020}) {
    const auto scaled = [scale](const Vec3& v) { return v * scale; };
    const Triangle s{{}, scaled(b), scaled(c)};
    const Triangle t{scaled(above), scaled(b + c - above), scaled(b - above)};
    const Vec3 first = scaled(0.5 * b);
    const Vec3 last = scaled(0.5 * (b + c));
    for (const CommonPoints& found : {common_points(s, t), common_points(t, s)}) {
      ASSERT_EQ(found.count, 2U);
      const bool turned = found.corners[0] == last;
      EXPECT_EQ(found.corners[turned ? 1 : 0], first) << scale;
      EXPECT_EQ(found.corners[turned ? 0 : 1], last) << scale;
    }
  }
}

TEST(CrossingSegment, GivesThePointWhereEdgesCrossThatAreUnlikeInLength) {
  const Vec3 far{0.6, 0.7, 0.8};
  for (const double tiny : {0x1p-100, 0x1p-120, 0x1p-800}) {
    const Triangle s{{tiny, 0, 0}, {-tiny, 0, 0}, {-tiny, 0, 0}};
    const Triangle t{far * -1, far, far};
    for (const CommonPoints& found : {common_points(s, t), common_points(t, s)}) {
      ASSERT_EQ(found.count, 1U) << tiny;
      EXPECT_LE(std::abs(found.corners[0].x), tiny);
      EXPECT_LE(std::abs(found.corners[0].y), tiny);
    }
  }
}

TEST(CrossingSegment, LiesOnBothTrianglesAndLosesNothing) {
  std::size_t touching = 0;
  test::for_each_case("crossing/random", 4000, [&touching](Rng& rng) {
    const auto point = [&rng] {
      return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    const Triangle s{point(), point(), point()};
    const Triangle t{point(), point(), point()};
    expect_sound(s, t, touching);
    expect_whole(s, t);
  });
  EXPECT_GT(touching, 200U);
}

TEST(CrossingSegment, LiesOnBothTrianglesOfAGrid) {
  // Small integers: coplanar, collinear and shared corners are common.
  std::size_t touching = 0;
  test::for_each_case("crossing/grid", 4000, [&touching](Rng& rng) {
    const auto point = [&rng] {
      return Vec3{static_cast<double>(rng.below(4)), static_cast<double>(rng.below(4)),
                  static_cast<double>(rng.below(2))};
    };
    const Triangle s{point(), point(), point()};
    const Triangle t{point(), point(), point()};
    expect_sound(s, t, touching);
    expect_whole(s, t);
  });
  EXPECT_GT(touching, 200U);
}

TEST(CrossingSegment, LiesOnBothTrianglesFarFromTheOrigin) {
  std::size_t touching = 0;
  test::for_each_case("crossing/far", 1000, [&touching](Rng& rng) {
    const Vec3 at{rng.uniform(-1e6, 1e6), rng.uniform(-1e6, 1e6), rng.uniform(-100, 100)};
    const auto point = [&] {
      return at + Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    expect_sound({point(), point(), point()}, {point(), point(), point()}, touching);
  });
  EXPECT_GT(touching, 50U);
}

TEST(CrossingSegment, ServesSliversAndNearlyFlatPairs) {
  std::size_t touching = 0;
  test::for_each_case("crossing/sliver", 2000, [&touching](Rng& rng) {
    const double thin = std::exp2(-rng.uniform(0, 20));
    const double tilt = std::exp2(-rng.uniform(0, 50));
    const auto point = [&] {
      return Vec3{rng.uniform(-1, 1), thin * rng.uniform(-1, 1), tilt * rng.uniform(-1, 1)};
    };
    expect_sound({point(), point(), point()}, {point(), point(), point()}, touching);
  });
  EXPECT_GT(touching, 100U);
}

TEST(CrossingSegment, ExistsExactlyForTouchingPairsOfTheTruthSet) {
  std::size_t touching = 0;
  for (const test::TruthTriangles& pair : test::truth_triangles()) {
    if (pair.kind == "huge") {
      continue;
    }
    const CommonPoints found = common_points(pair.s, pair.t);
    ASSERT_EQ(!found.empty(), pair.overlap);
    touching += pair.overlap ? 1U : 0U;
    for (const Vec3& p : found.points()) {
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
  }
  EXPECT_GT(touching, 5000U);
}

}  // namespace
}  // namespace soms
