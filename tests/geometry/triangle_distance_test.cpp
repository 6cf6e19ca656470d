#include "soms/geometry/triangle_distance.h"

#include "soms/geometry/triangle_overlap.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/distance_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>

namespace soms {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

Triangle reordered(const Triangle& t, const std::array<std::size_t, 3>& order) {
  const std::array corners{t.a, t.b, t.c};
  return {corners[order[0]], corners[order[1]], corners[order[2]]};
}

Triangle scaled(const Triangle& t, double factor) {
  return {t.a * factor, t.b * factor, t.c * factor};
}

double largest(const Triangle& t) {
  double most = 0;
  for (const Vec3& v : {t.a, t.b, t.c}) {
    most = std::max({most, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  }
  return most;
}

/// A unit in the last place of the largest coordinate.
double unit_of(const Triangle& a, const Triangle& b) {
  const double most = std::max(largest(a), largest(b));
  return std::nextafter(most, kInfinity) - most;
}

Triangle at_point(const Vec3& p) {
  return {p, p, p};
}

/// The points are on their triangles and as far apart as the triangles are, but for rounding.
void expect_right_points(const Triangle& a, const Triangle& b, const TriangleDistance& found) {
  const double room = 4 * unit_of(a, b);
  EXPECT_TRUE(triangles_within(a, at_point(found.point_a), room));
  EXPECT_TRUE(triangles_within(b, at_point(found.point_b), room));
  const Bracket between =
      triangle_distance(at_point(found.point_a), at_point(found.point_b)).distance;
  EXPECT_LE(between.lower, found.distance.upper + 2 * room);
  EXPECT_GE(between.upper, found.distance.lower - 2 * room);
  if (found.distance.upper == 0) {
    EXPECT_EQ(found.point_a, found.point_b);
  }
}

void expect_distance(const Triangle& a, const Triangle& b, const Bracket& expected) {
  const TriangleDistance found = triangle_distance(a, b);
  EXPECT_EQ(found.distance.lower, expected.lower);
  EXPECT_EQ(found.distance.upper, expected.upper);
  expect_right_points(a, b, found);
}

void expect_within(const Triangle& a, const Triangle& b, const Bracket& distance) {
  EXPECT_TRUE(triangles_within(a, b, distance.upper));
  EXPECT_EQ(triangles_within(a, b, distance.lower), distance.lower == distance.upper);
  EXPECT_TRUE(triangles_within(a, b, kInfinity));
  EXPECT_EQ(triangles_within(a, b, 0), distance.upper == 0);
  if (distance.lower > 0) {
    EXPECT_FALSE(triangles_within(a, b, std::nextafter(distance.lower, 0)));
  }
}

std::string trace(const test::TriangleDistanceRow& row, std::size_t i) {
  return row.kind + ", row " + std::to_string(i);
}

TEST(TriangleDistance, IsTheTruth) {
  std::map<std::string, int> zeros;
  std::map<std::string, int> rows;
  for (std::size_t i = 0; i < test::triangle_distances().size(); ++i) {
    const test::TriangleDistanceRow& row = test::triangle_distances()[i];
    SCOPED_TRACE(trace(row, i));
    expect_distance(row.a, row.b, row.distance);
    expect_distance(row.b, row.a, row.distance);
    expect_within(row.a, row.b, row.distance);
    EXPECT_EQ(row.distance.upper == 0, row.zero);
    EXPECT_EQ(triangles_overlap(row.a, row.b), row.zero);
    ++rows[row.kind];
    zeros[row.kind] += row.zero ? 1 : 0;
    if (HasFailure()) {
      return;
    }
  }
  EXPECT_EQ(rows.size(), 12U);
  EXPECT_GE(rows["tiny"], 20);
  EXPECT_GE(zeros["tiny"], 8);
  EXPECT_GE(rows["exponents"], 20);
}

// 72 orders of arguments and corners, on a part of the rows.
TEST(TriangleDistance, DoesNotDependOnTheOrderOfCorners) {
  const std::size_t step = std::max<std::size_t>(1, test::triangle_distances().size() / 300);
  for (std::size_t i = 0; i < test::triangle_distances().size(); i += step) {
    const test::TriangleDistanceRow& row = test::triangle_distances()[i];
    SCOPED_TRACE(trace(row, i));
    const TriangleDistance first = triangle_distance(row.a, row.b);
    const double room = 2 * unit_of(row.a, row.b);
    for (const auto& order_a : kOrders) {
      for (const auto& order_b : kOrders) {
        const Triangle a = reordered(row.a, order_a);
        const Triangle b = reordered(row.b, order_b);
        const TriangleDistance found = triangle_distance(a, b);
        ASSERT_EQ(found.distance, row.distance);
        ASSERT_TRUE(triangles_within(at_point(first.point_a), at_point(found.point_a), room));
        ASSERT_TRUE(triangles_within(at_point(first.point_b), at_point(found.point_b), room));
        const TriangleDistance exchanged = triangle_distance(b, a);
        ASSERT_EQ(exchanged.distance, row.distance);
        ASSERT_TRUE(triangles_within(at_point(first.point_a), at_point(exchanged.point_b), room));
        ASSERT_TRUE(triangles_within(at_point(first.point_b), at_point(exchanged.point_a), room));
      }
    }
  }
}

TEST(TriangleDistance, ScalesByPowersOfTwo) {
  int tried = 0;
  for (std::size_t i = 0; i < test::triangle_distances().size(); i += test::kSlowBuild ? 8 : 1) {
    const test::TriangleDistanceRow& row = test::triangle_distances()[i];
    SCOPED_TRACE(trace(row, i));
    for (const int power : {-700, -300, -101, -3, 1, 77, 99, 160, 290}) {
      const double factor = std::ldexp(1.0, power);
      const Triangle a = scaled(row.a, factor);
      const Triangle b = scaled(row.b, factor);
      const Bracket expected{row.distance.lower * factor, row.distance.upper * factor};
      // Distances have all their bits on both scales, and coordinates are in range.
      const bool exact = scaled(a, 1 / factor) == row.a && scaled(b, 1 / factor) == row.b &&
                         (row.zero || std::min(expected.lower, row.distance.lower) >= 0x1p-1021) &&
                         std::max(largest(a), largest(b)) <= 0x1p300;
      if (exact) {
        ++tried;
        ASSERT_EQ(triangle_distance(a, b).distance, expected) << power;
      }
    }
  }
  EXPECT_GT(tried, test::kSlowBuild ? 100 : 1000);
}

constexpr Triangle kUnit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(TriangleDistance, NamesTheMiddleOfParallelFeatures) {
  // Faces: the triangle above is over the lower one's middle.
  const Triangle above{{0.25, 0.25, 2}, {0.5, 0.25, 2}, {0.25, 0.5, 2}};
  TriangleDistance found = triangle_distance(kUnit, above);
  EXPECT_EQ(found.distance, (Bracket{2, 2}));
  EXPECT_EQ(found.point_a, (Vec3{1 / 3.0, 1 / 3.0, 0}));
  EXPECT_EQ(found.point_b, (Vec3{1 / 3.0, 1 / 3.0, 2}));
  // Faces that cut each other's edges: a square of corners (0, 0), (1/2, 0), (1/2, 1/2), (0, 1/2).
  const Triangle aslant{{0.5, 0.5, 3}, {-0.5, 0.5, 3}, {0.5, -0.5, 3}};
  found = triangle_distance(kUnit, aslant);
  EXPECT_EQ(found.distance, (Bracket{3, 3}));
  EXPECT_EQ(found.point_a, (Vec3{0.25, 0.25, 0}));
  EXPECT_EQ(found.point_b, (Vec3{0.25, 0.25, 3}));
  // Edges: one from 0 to 1, the other from 1/2 to 3.
  const Triangle beside{{0.5, -4, 0}, {3, -4, 0}, {1, -5, 1}};
  found = triangle_distance(kUnit, beside);
  EXPECT_EQ(found.distance, (Bracket{4, 4}));
  EXPECT_EQ(found.point_a, (Vec3{0.75, 0, 0}));
  EXPECT_EQ(found.point_b, (Vec3{0.75, -4, 0}));
  // An edge over a face, of which it leaves at (3/4, 1/4).
  const Triangle upright{{0.25, 0.25, 1}, {1.25, 0.25, 1}, {0.25, 0.25, 9}};
  found = triangle_distance(upright, kUnit);
  EXPECT_EQ(found.distance, (Bracket{1, 1}));
  EXPECT_EQ(found.point_a, (Vec3{0.5, 0.25, 1}));
  EXPECT_EQ(found.point_b, (Vec3{0.5, 0.25, 0}));
}

TEST(TriangleDistance, NamesTheMiddleOfWhatIsInCommon) {
  // A triangle through the face: from (1/4, 1/4) to (3/4, 1/4), where the face ends.
  const Triangle through{{0.25, 0.25, -1}, {0.25, 0.25, 1}, {2.25, 0.25, 0}};
  TriangleDistance found = triangle_distance(kUnit, through);
  EXPECT_EQ(found, (TriangleDistance{{0, 0}, {0.5, 0.25, 0}, {0.5, 0.25, 0}}));
  // Within the face's plane: the square.
  const Triangle aslant{{0.5, 0.5, 0}, {-0.5, 0.5, 0}, {0.5, -0.5, 0}};
  found = triangle_distance(kUnit, aslant);
  EXPECT_EQ(found, (TriangleDistance{{0, 0}, {0.25, 0.25, 0}, {0.25, 0.25, 0}}));
  // The same triangle, in another order.
  found = triangle_distance({{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{0, 3, 0}, {0, 0, 0}, {3, 0, 0}});
  EXPECT_EQ(found, (TriangleDistance{{0, 0}, {1, 1, 0}, {1, 1, 0}}));
  // Edges in the space between that cross.
  found =
      triangle_distance({{0, -1, 0}, {0, 1, 0}, {0, 0, -5}}, {{-1, 0, 0}, {3, 0, 0}, {0, 0, 5}});
  EXPECT_EQ(found, (TriangleDistance{{0, 0}, {0, 0, 0}, {0, 0, 0}}));
}

// Edges that cross at an angle of 2^-2 to 2^-26, and corners above faces as thin.
TEST(TriangleDistance, NamesPointsOfNearlyParallelEdgesAndThinFaces) {
  test::for_each_case("triangle-distance/thin", 3000, [](Rng& rng) {
    const auto any = [&] {
      return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    const double angle = std::exp2(-rng.uniform(2, 26));
    const Vec3 edge = any();
    const Vec3 turned = edge + angle * any();
    const Vec3 up = rng.unit() * Vec3{-edge.y, edge.x, 0};
    const Vec3 p = any();
    const Triangle thin{p - edge, p + edge, p + turned - up * angle};
    const Triangle other = rng.below(2) == 0
                               ? Triangle{p + up - turned, p + up + turned, p + 2 * up}
                               : Triangle{p + up, p + 2 * up + any(), p + 3 * up};
    expect_right_points(thin, other, triangle_distance(thin, other));
    expect_right_points(other, thin, triangle_distance(other, thin));
  });
}

TEST(TriangleDistance, TakesTrianglesWithoutAreaAsSegmentsAndPoints) {
  const Triangle segment{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};
  const Triangle point = at_point({1, 3, 4});
  EXPECT_EQ(triangle_distance(segment, point).distance, (Bracket{5, 5}));
  EXPECT_EQ(triangle_distance(segment, point).point_a, (Vec3{1, 0, 0}));
  EXPECT_EQ(triangle_distance(point, at_point({1, 3, 4})).distance, (Bracket{0, 0}));
  EXPECT_EQ(triangle_distance(point, at_point({1, 3, 4})).point_a, (Vec3{1, 3, 4}));
  const Triangle limits{{2, 2, 0}, {9, 2, 0}, {3, 2, 0}};
  EXPECT_EQ(triangle_distance(segment, limits), (TriangleDistance{{2, 2}, {3, 0, 0}, {3, 2, 0}}));
  const Triangle within{{1, 0, 0}, {3, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(triangle_distance(segment, within), (TriangleDistance{{0, 0}, {2, 0, 0}, {2, 0, 0}}));
}

TEST(TriangleDistance, HasNoLeastSize) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  const Triangle a = at_point({0, 0, 0});
  EXPECT_EQ(triangle_distance(a, at_point({kTiny, 0, 0})).distance, (Bracket{kTiny, kTiny}));
  EXPECT_EQ(triangle_distance(a, at_point({kTiny, kTiny, 0})).distance,
            (Bracket{kTiny, 2 * kTiny}));
  // The foot of a corner is nearer to it than the least double.
  const Triangle slope{{0, 0, 0}, {kTiny, kTiny, 0}, {0, 0, 1}};
  EXPECT_EQ(triangle_distance(slope, at_point({kTiny, 0, 0})).distance, (Bracket{0, kTiny}));
  EXPECT_FALSE(triangles_within(slope, at_point({kTiny, 0, 0}), 0));
  const Triangle wide{{0, 0, 0}, {0x1p300, 0x1p300, 0}, {0, 0, 1}};
  EXPECT_EQ(triangle_distance(wide, at_point({kTiny, 0, 0})).distance, (Bracket{0, kTiny}));
  EXPECT_EQ(triangle_distance(at_point({-0x1p300, 0, 0}), at_point({0x1p300, 0, 0})).distance,
            (Bracket{0x1p301, 0x1p301}));
}

TEST(Regression, R05TheDistanceOfTwoTrianglesHasNoOrder) {
  const Triangle a{{32.22699737548828, 1.2630000114440918, -11.8149995803833},
                   {31.316997528076172, 1.2630000114440918, -11.739999771118164},
                   {32.22699737548828, 1.2630000114440918, -11.739999771118164}};
  const Triangle b{{31.316997528076172, 1.933000087738037, -7.585000038146973},
                   {31.316997528076172, -0.8669999837875366, -7.295000076293945},
                   {31.316997528076172, -0.8669999837875366, -7.585000038146973}};
  for (const auto& order_a : kOrders) {
    for (const auto& order_b : kOrders) {
      const Triangle p = reordered(a, order_a);
      const Triangle q = reordered(b, order_b);
      expect_distance(p, q, {4.154999732971191, 4.154999732971191});
      expect_distance(q, p, {4.154999732971191, 4.154999732971191});
    }
  }
}

TEST(Regression, R07ParallelTrianglesHaveTheirGapForDistance) {
  for (const double gap : {0.0, 0x1p-40, 0x1p-30, 0x1p-20}) {
    const Triangle above{{0, 0, gap}, {1, 0, gap}, {0, 1, gap}};
    expect_distance(kUnit, above, {gap, gap});
    EXPECT_EQ(triangles_overlap(kUnit, above), gap == 0);
  }
}

TEST(Regression, R28EdgesThatCrossAreNearest) {
  const Triangle flat{{-1, 0, 0}, {1, 0, 0}, {0, -2, 0}};
  for (const double gap : {0.0, 0x1p-10}) {
    const Triangle upright{{0, -1, gap}, {0, 1, gap}, {0, 0, 2}};
    expect_distance(flat, upright, {gap, gap});
  }
}

TEST(Regression, R29TrianglesWithoutAreaHaveADistance) {
  const Vec3 twice{-0.569999993, -8.10000038, 16.6070004};
  const Triangle segment{{2.27699995, -7.9000001, 16.3180008}, twice, twice};
  const Bracket found =
      triangle_distance(segment, at_point({1.10000002, -7.9000001, 16.5879993})).distance;
  EXPECT_NEAR(found.lower, 0.17147826590, 1e-11);
}

// 1.42 mm above a triangle of the hull; the answer was a depth of 7 mm.
TEST(Regression, R42AThinTriangleAboveAFaceIsApart) {
  const Triangle face{{-0.1, -0.1, 0}, {0.2, -0.1, 0}, {-0.1, 0.2, 0}};
  const Triangle thin{{0, 0, 0.00142}, {0.03, 0.001, 0.00142}, {0.03, 0.0011, 0.00342}};
  expect_distance(face, thin, {0.00142, 0.00142});
}

}  // namespace
}  // namespace soms
