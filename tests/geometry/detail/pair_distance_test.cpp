#include "soms/geometry/detail/pair_distance.h"

#include "soms/geometry/detail/feature_proof.h"

#include "tests/support/support.h"
#include "tests/support/truth/distance_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace soms::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Row = test::TriangleDistanceRow;

/// Whether bounds hold a distance of which the doubles next to it are known.
bool hold(const Bracket& bounds, const Bracket& d) {
  return bounds.lower >= 0 && bounds.lower <= d.lower && bounds.upper >= d.upper;
}

template <class T>
Bracket bounds_of(const Row& row, const FeaturePair& features) {
  const AboutCorner<T> place(row.a, row.b);
  if (place.reach == 0) {
    return {0, 0};
  }
  const Ends<T> found = ends(place, features);
  const auto unit = [&](double x) { return std::ldexp(x, place.exponent); };
  if constexpr (std::is_same_v<T, double>) {
    return {unit(found.lower), unit(found.upper)};
  } else {
    return {unit(found.lower.high), unit(found.upper.high)};
  }
}

// Bounds are proofs for any pair of features, not only for the nearest.
TEST(DistanceEnds, HoldTheDistanceWhateverFeaturesAreTaken) {
  std::size_t tight = 0;
  for (const Row& row : test::triangle_distances()) {
    SCOPED_TRACE(row.kind);
    Bracket best{0, kInfinity};
    for (const FeaturePair& features : kFeaturePairs) {
      const Bracket doubles = bounds_of<double>(row, features);
      const Bracket twice = bounds_of<DoubleDouble>(row, features);
      for (const Bracket& b : {doubles, twice}) {
        // Rounded to the nearest double, a bound may be the double beyond the distance.
        ASSERT_LE(b.lower, row.distance.upper);
        ASSERT_GE(b.upper, row.distance.lower);
      }
      best = {std::max(best.lower, twice.lower), std::min(best.upper, twice.upper)};
    }
    tight += best.upper - best.lower <= 0x1p-50 * best.upper ? 1 : 0;
  }
  EXPECT_GT(tight, test::triangle_distances().size() / 2);
}

TEST(PairDistance, BoundsHoldTheDistanceAtEachStage) {
  for (const Row& row : test::triangle_distances()) {
    SCOPED_TRACE(row.kind);
    PairDistance pair(row.a, row.b);
    ASSERT_TRUE(hold(pair.bounds(), row.distance));
    // A question next to the distance needs all stages.
    const Bracket before = pair.bounds();
    ASSERT_TRUE(pair.compare(row.distance.upper) <= 0);
    ASSERT_TRUE(hold(pair.bounds(), row.distance));
    ASSERT_LE(before.lower, pair.bounds().lower);
    ASSERT_GE(before.upper, pair.bounds().upper);
    ASSERT_EQ(pair.distance(), row.distance);
    ASSERT_EQ(pair.bounds(), row.distance);
  }
}

TEST(PairDistance, ComparesWithDoubles) {
  for (const Row& row : test::triangle_distances()) {
    SCOPED_TRACE(row.kind);
    const auto order = [&](double d) { return PairDistance(row.a, row.b).compare(d); };
    const auto [lower, upper] = row.distance;
    const bool is_double = lower == upper;
    ASSERT_EQ(order(lower),
              is_double ? std::strong_ordering::equal : std::strong_ordering::greater);
    ASSERT_EQ(order(upper), is_double ? std::strong_ordering::equal : std::strong_ordering::less);
    ASSERT_EQ(order(kInfinity), std::strong_ordering::less);
    ASSERT_EQ(order(std::nextafter(upper, kInfinity)), std::strong_ordering::less);
    ASSERT_EQ(order(0), row.zero ? std::strong_ordering::equal : std::strong_ordering::greater);
  }
}

// Rows in the order of their distances, and each against itself with arguments exchanged and
// corners turned, which is an exact tie.
TEST(PairDistance, ComparesExactly) {
  std::vector<Row> rows = test::triangle_distances();
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.distance.lower < b.distance.lower ||
           (a.distance.lower == b.distance.lower && a.distance.upper < b.distance.upper);
  });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    SCOPED_TRACE(rows[i].kind);
    PairDistance here(rows[i].a, rows[i].b);
    const Triangle& a = rows[i].a;
    const Triangle& b = rows[i].b;
    PairDistance turned({b.c, b.a, b.b}, {a.b, a.a, a.c});
    ASSERT_EQ(here.compare(turned), std::strong_ordering::equal);
    ASSERT_EQ(turned.compare(here), std::strong_ordering::equal);
    PairDistance same(a, b);
    ASSERT_EQ(same.compare(same), std::strong_ordering::equal);
    if (i > 0 && rows[i - 1].distance != rows[i].distance) {
      PairDistance before(rows[i - 1].a, rows[i - 1].b);
      PairDistance after(a, b);
      ASSERT_EQ(before.compare(after), std::strong_ordering::less);
      ASSERT_EQ(after.compare(before), std::strong_ordering::greater);
    }
  }
}

// Distances of the same doubles that differ all the same: corner and edge, 2^-60 apart.
TEST(PairDistance, TellsApartWhatDoublesDoNot) {
  const Triangle point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const auto at = [](double x, double y) { return Triangle{{x, y, 0}, {x, y, 0}, {x, y, 0}}; };
  PairDistance straight(point, at(3, 0x1p-40));
  PairDistance wider(point, at(3, 0x1p-40 + 0x1p-60));
  EXPECT_EQ(straight.distance(), wider.distance());
  EXPECT_EQ(straight.compare(wider), std::strong_ordering::less);
  EXPECT_EQ(wider.compare(straight), std::strong_ordering::greater);
}

// Two fans about the nearest corners: all pairs tie, and none needs whole numbers.
TEST(PairDistance, SharedFeaturesTieWithoutWholeNumbers) {
  const Vec3 tip_a{0.1, 0.2, 0.3};
  const Vec3 tip_b{1.7, 0.3, 0.7};
  const auto fan = [](const Vec3& tip, double side, double turn) {
    return Triangle{tip, tip + Vec3{side, 0.1 * std::sin(turn), 0.1 * std::cos(turn)},
                    tip + Vec3{side, 0.1 * std::sin(turn + 1), 0.1 * std::cos(turn + 1)}};
  };
  PairDistance first(fan(tip_a, -1, 0), fan(tip_b, 1, 0));
  for (int i = 1; i < 6; ++i) {
    PairDistance other(fan(tip_a, -1, i), fan(tip_b, 1, 2 * i));
    EXPECT_EQ(first.compare(other), std::strong_ordering::equal);
    EXPECT_EQ(other.exact_tests(), 0U);
  }
  EXPECT_EQ(first.exact_tests(), 0U);
  // An edge in common, seen from a corner in common.
  const Vec3 begin{2, -1, 0.1};
  const Vec3 end{2, 1, 0.3};
  PairDistance edge(fan(tip_a, -1, 0), {begin, end, {3, 0, 1}});
  PairDistance same_edge(fan(tip_a, -1, 2), {{3, 0, -1}, end, begin});
  EXPECT_EQ(edge.compare(same_edge), std::strong_ordering::equal);
  EXPECT_EQ(edge.exact_tests() + same_edge.exact_tests(), 0U);
}

/// A point, and the order of its distances to two triangles as whole numbers have it.
void expect_exact_order(const Triangle& p, const Triangle& b, const Triangle& c) {
  const auto exact = [&](const Triangle& t) {
    return exact_distance(ExactPair(p, t), {0, 0}).squared;
  };
  PairDistance to_b(p, b);
  PairDistance to_c(p, c);
  ASSERT_EQ(to_b.compare(to_c), compare(exact(b), exact(c)));
}

// A corner in common that is guessed to be nearest, where it is not, by less than doubles tell.
TEST(PairDistance, CornersThatAreNearlyNearestDoNotTie) {
  test::for_each_case("pair-distance/nearly", 500, [](Rng& rng) {
    const auto any = [&] {
      return Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    };
    const Triangle origin{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    const Vec3 q = any();
    const Triangle beyond{q, 2 * q + cross(q, any()), 3 * q + cross(q, any())};
    const Triangle beside{q, q + cross(q, any()), 2 * q + cross(q, any())};
    ASSERT_NO_FATAL_FAILURE(expect_exact_order(origin, beyond, beside));
  });
}

// The distance from a corner, and from the inside of an edge that ends in it.
TEST(PairDistance, AnEdgeDoesNotTieWithItsCorner) {
  const Vec3 q{0x1p-40, 1, 0};
  const Triangle above{q, q + Vec3{0, 1, 0.5}, q + Vec3{0.25, 1, -0.5}};
  const Triangle corner_first{{0, 0, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const Triangle edge_first{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}};
  PairDistance from_corner(corner_first, above);
  PairDistance from_edge(edge_first, above);
  EXPECT_EQ(from_corner.compare(from_edge), std::strong_ordering::greater);
  EXPECT_EQ(from_edge.compare(from_corner), std::strong_ordering::less);
}

TEST(FeatureProof, AgreesWithWholeNumbers) {
  std::size_t proved = 0;
  for (const Row& row : test::triangle_distances()) {
    const ExactPair pair(row.a, row.b);
    for (const FeaturePair& features : kFeaturePairs) {
      if (prove(row.a, row.b, features).nearest) {
        ++proved;
        ASSERT_TRUE(pair.squared_distance(features)) << row.kind;
        ASSERT_FALSE(row.zero);
      }
    }
  }
  EXPECT_GT(proved, test::triangle_distances().size() / 4);
}

TEST(PairDistance, CountsWholeNumbers) {
  const Triangle slanted{{0, 0, 0}, {-4, 3, 0}, {0, 0, 1}};
  const Vec3 tip{2, 4.75, 0.25};  // (3, 4, 0) above it
  PairDistance five(slanted, {tip, tip + Vec3{3, 4, 1}, tip + Vec3{3, 4, -1}});
  EXPECT_EQ(five.exact_tests(), 0U);
  EXPECT_EQ(five.compare(4), std::strong_ordering::greater);
  EXPECT_EQ(five.compare(6), std::strong_ordering::less);
  EXPECT_EQ(five.exact_tests(), 0U);
  EXPECT_EQ(five.compare(5), std::strong_ordering::equal);
  EXPECT_EQ(five.exact_tests(), 1U);
  EXPECT_EQ(five.compare(5), std::strong_ordering::equal);
  EXPECT_EQ(five.exact_tests(), 1U);
}

TEST(PairDistance, IsZeroByDefault) {
  PairDistance nothing;
  EXPECT_EQ(nothing.bounds(), (Bracket{0, 0}));
  EXPECT_EQ(nothing.compare(0), std::strong_ordering::equal);
}

}  // namespace
}  // namespace soms::detail
