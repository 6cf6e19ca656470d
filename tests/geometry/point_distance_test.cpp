#include "soms/geometry/point_distance.h"

#include "soms/geometry/detail/exact_point.h"
#include "soms/geometry/print.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>

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
