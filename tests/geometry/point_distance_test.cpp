#include "soms/geometry/point_distance.h"

#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/point_to_triangle.h"
#include "soms/geometry/print.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <compare>
#include <limits>

namespace soms {
namespace {

constexpr Triangle kHalfSquare{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};

TEST(PointDistance, IsThatOfTheFaceAboveIt) {
  EXPECT_EQ(point_distance({1, 1, 2}, kHalfSquare),
            (PointDistance{{2, 2}, {1, 1, 0}, TriangleFeature::face}));
}

TEST(PointDistance, IsThatOfEdgesAndCornersBesideIt) {
  EXPECT_EQ(point_distance({1, -3, 4}, kHalfSquare),
            (PointDistance{{5, 5}, {1, 0, 0}, TriangleFeature::edge}));
  EXPECT_EQ(point_distance({-3, 0, -4}, kHalfSquare),
            (PointDistance{{5, 5}, {0, 0, 0}, TriangleFeature::vertex}));
}

TEST(PointDistance, IsZeroOnTheTriangleAlone) {
  EXPECT_EQ(point_distance({2, 2, 0}, kHalfSquare),
            (PointDistance{{0, 0}, {2, 2, 0}, TriangleFeature::edge}));
  EXPECT_EQ(point_distance({1, 2, 0}, kHalfSquare).distance, (Bracket{0, 0}));
  const double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(point_distance({1, 2, least}, kHalfSquare),
            (PointDistance{{least, least}, {1, 2, 0}, TriangleFeature::face}));
}

TEST(PointDistance, IsZeroOnASlopeToo) {
  constexpr Triangle kSlope{{0, 0, 0}, {4, 0, -4}, {0, 4, -4}};
  EXPECT_EQ(point_distance({1, 2, -3}, kSlope).distance, (Bracket{0, 0}));
  EXPECT_EQ(point_distance({2, 2, -4}, kSlope),
            (PointDistance{{0, 0}, {2, 2, -4}, TriangleFeature::edge}));
  EXPECT_GT(point_distance({1, 2, std::nextafter(-3, 0)}, kSlope).distance.lower, 0);
}

// Walls, floors and roofs are across an axis: their distances are differences of two doubles.
TEST(PointDistance, NeedsNoWholeNumbersAcrossAnAxis) {
  constexpr double kWall = 0.1;
  const Triangle wall{{kWall, 0, 0}, {kWall, 4, 0}, {kWall, 0, 4}};
  for (const double x : {0.7, -0.3, 1e-20, kWall, std::nextafter(kWall, 1)}) {
    detail::PointToTriangle pair({x, 1.3, 0.9}, wall);
    const detail::DoubleDouble gap =
        x < kWall ? detail::two_sum(kWall, -x) : detail::two_sum(x, -kWall);
    EXPECT_EQ(pair.distance(), (Bracket{detail::below(gap), detail::above(gap)})) << x;
    EXPECT_EQ(pair.nearest(), (Vec3{kWall, 1.3, 0.9}));
    EXPECT_EQ(pair.feature(), TriangleFeature::face);
    EXPECT_EQ(pair.compare(detail::below(gap)) == 0, gap.low == 0) << x;
    EXPECT_EQ(pair.exact_tests(), 0U) << x;
  }
  // Beside an edge along an axis and beside a corner the way has two coordinates, and three.
  EXPECT_EQ(point_distance({kWall + 3, 1, -4}, wall),
            (PointDistance{point_distance({kWall + 3, 1, -4}, wall).distance,
                           {kWall, 1, 0},
                           TriangleFeature::edge}));
}

// Walls of one height, as far on both sides, are equally far, and known to be without a count.
TEST(PointDistance, KnowsExactTiesOfWalls) {
  detail::PointToTriangle left({0.75, 1, 1}, {{0.5, 0, 0}, {0.5, 4, 0}, {0.5, 0, 4}});
  detail::PointToTriangle right({0.75, 1, 1}, {{1, 0, 0}, {1, 4, 0}, {1, 0, 4}});
  EXPECT_EQ(left.compare(right), std::strong_ordering::equal);
  detail::PointToTriangle nearer(
      {0.75, 1, 1},
      {{std::nextafter(1, 0), 0, 0}, {std::nextafter(1, 0), 4, 0}, {std::nextafter(1, 0), 0, 4}});
  EXPECT_EQ(nearer.compare(left), std::strong_ordering::less);
  EXPECT_EQ(left.compare(nearer), std::strong_ordering::greater);
  EXPECT_EQ(left.exact_tests() + right.exact_tests() + nearer.exact_tests(), 0U);
}

TEST(DoubleDouble, NeighborsOfDoublesAreThoseOfTheLibrary) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x : {0.0, -0.0, 1.0, -1.0, 0.1, std::numeric_limits<double>::denorm_min(),
                         -std::numeric_limits<double>::denorm_min(), 0x1p-1022, -0x1p-1022,
                         std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()}) {
    EXPECT_EQ(detail::next_above(x), std::nextafter(x, kInfinity)) << x;
    EXPECT_EQ(detail::next_below(x), std::nextafter(x, -kInfinity)) << x;
  }
}

// The third corner is within the side between the others, and a guess in doubles is that side.
TEST(PointDistance, NamesTheCornerWithinAnEdgeOfATriangleWithoutArea) {
  const Triangle flat{{0, 0, 0}, {6, 10, 14}, {3, 5, 7}};
  const PointDistance found =
      point_distance({166848069752376, 2032727588089276, -1523454592814775}, flat);
  EXPECT_EQ(found.feature, TriangleFeature::vertex);
  EXPECT_EQ(found.point, (Vec3{3, 5, 7}));
}

TEST(PointDistance, HoldsForSegmentsAndPoints) {
  EXPECT_EQ(point_distance({1, 3, 4}, {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}),
            (PointDistance{{5, 5}, {1, 0, 0}, TriangleFeature::vertex}));
  EXPECT_EQ(point_distance({0.5, 3, 4}, {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}),
            (PointDistance{{5, 5}, {0.5, 0, 0}, TriangleFeature::edge}));
  EXPECT_EQ(point_distance({3, 4, 0}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}),
            (PointDistance{{5, 5}, {0, 0, 0}, TriangleFeature::vertex}));
  EXPECT_EQ(point_distance({0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}).distance, (Bracket{0, 0}));
}

TEST(PointDistance, HoldsAtTheEndsOfTheRange) {
  constexpr double kBig = 0x1p300;
  const PointDistance far = point_distance({kBig, kBig, kBig}, kHalfSquare);
  EXPECT_GT(far.distance.lower, kBig);
  EXPECT_EQ(far.feature, TriangleFeature::edge);
  EXPECT_EQ(
      point_distance({0, 0, -kBig}, {{-kBig, -kBig, kBig}, {kBig, -kBig, kBig}, {0, kBig, kBig}}),
      (PointDistance{{2 * kBig, 2 * kBig}, {0, 0, kBig}, TriangleFeature::face}));
  constexpr double kTiny = 0x1p-1074;
  EXPECT_EQ(point_distance({kTiny, kTiny, kTiny}, kHalfSquare).distance, (Bracket{kTiny, kTiny}));
}

// The double next to a quotient of whole numbers, by the middle of its neighbors.
TEST(NearestDouble, RoundsToNearestAndTiesToEven) {
  using detail::Integer;
  using detail::nearest_double;
  EXPECT_EQ(nearest_double(Integer(1), Integer(3), 0), 1.0 / 3);
  EXPECT_EQ(nearest_double(Integer(-2), Integer(3), 5), -64.0 / 3);
  EXPECT_EQ(nearest_double(Integer((std::int64_t{1} << 53) + 1), Integer(1), 0), 0x1p53);
  EXPECT_EQ(nearest_double(Integer((std::int64_t{1} << 53) + 3), Integer(1), 0), 0x1p53 + 4);
  EXPECT_EQ(nearest_double(Integer(1), Integer(2), -1074), 0);
  EXPECT_EQ(nearest_double(Integer(3), Integer(2), -1074), 0x1p-1073);
  EXPECT_EQ(nearest_double(Integer(0), Integer(7), 3), 0);
  EXPECT_FALSE(std::signbit(nearest_double(Integer(-1), Integer(4), -1074)));
}

}  // namespace
}  // namespace soms
