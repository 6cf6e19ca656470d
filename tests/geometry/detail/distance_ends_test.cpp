// Bounds of distances where least is left of what they grant, and where products underflow.
#include "soms/geometry/detail/distance_ends.h"

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/feature_proof.h"
#include "soms/geometry/detail/nearest_guess.h"
#include "soms/geometry/triangle_distance.h"

#include "tests/support/support.h"
#include "tests/support/truth/distance_truth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {
namespace {

/// Both bounds in doubles, of the features that doubles take for the nearest.
void expect_granted(const Triangle& a, const Triangle& b) {
  const AboutCorner<double> place(a, b);
  const Ends<double> found = ends(place, guess_features(place));
  const Bracket distance = triangle_distance(a, b).distance;
  EXPECT_LE(found.lower, distance.lower);
  EXPECT_GE(found.upper, distance.upper);
}

// They need 0.08 of what is taken off gaps, and 0.05 of what is added to lengths.
TEST(DistanceEnds, HoldAtTheWorstInputs) {
  expect_granted({{0x1.1015112bc1e9dp-2, -0x1.aad439d68f04p-2, 0x1.442cb25c46c33p-1},
                  {-0x1.3b578a83c326p-8, 0x1.ce9a5848d140bp-2, -0x1.b48c37ffddaaep-3},
                  {-0x1.2728608612fe4p-1, 0x1.9ec521af1de8fp-2, 0x1.bbca49f33a123p-11}},
                 {{0x1.0383fb2a3ad97p-2, -0x1.17131cec1d876p-3, 0x1.4b7f8c6ba56e1p-7},
                  {0x1.493d101087c3p-7, 0x1.ae66e17c66aeap-3, -0x1.b4864c7888d5ap-3},
                  {-0x1.dfdd3996a33e6p-1, -0x1.4f91b1c070972p-2, 0x1.b21602784f9fep-5}});
  expect_granted({{0x1.800000000021cp-1, 0x1.7ffffffe0bf46p-1, 0x1.0000000000002p-1},
                  {0x1.ffffffffffffep-3, 0x1.0000000000002p-3, 0x1.ffffffffffffbp-3},
                  {0x1.fffffffffffffp-4, 0x1.000000000962p-1, 0x1p-3}},
                 {{0x0.0000000000001p-1022, 0x1.ffffffffffffbp-3, 0x1p+0},
                  {0x1.8000000000001p-2, 0x0p+0, 0x1.0000000000001p-2},
                  {0x1.3fffffffff246p-1, 0x0p+0, 0x1.0000000000002p+0}});
}

/// Two triangles about the z-axis whose sides are `thin` across it, and about 1 apart.
std::array<Triangle, 2> thin_pair(Rng& rng, double thin) {
  const auto side = [&] { return thin * rng.uniform(-1, 1); };
  const auto at = [&](double z) { return Vec3{side(), side(), z}; };
  const Triangle a{{0, 0, 0}, at(side()), at(side())};
  return {a, {at(1), at(1), at(1)}};
}

template <class T>
void expect_bounds(const std::array<Triangle, 2>& pair, const Bracket& distance) {
  const AboutCorner<T> place(pair[0], pair[1]);
  ASSERT_EQ(place.exponent, 0);
  for (const FeaturePair& features : kFeaturePairs) {
    const Ends<T> found = ends(place, features);
    ASSERT_LE(DoubleDouble(found.lower).high, distance.upper);
    ASSERT_GE(DoubleDouble(found.upper).high, distance.lower);
  }
}

// Products of edges are directions of any size, down to nothing.
TEST(DistanceEnds, HoldAlongTinyDirections) {
  test::for_each_case("distance-ends/tiny", 1500, [](Rng& rng) {
    const std::array<Triangle, 2> pair = thin_pair(rng, std::exp2(-rng.uniform(100, 540)));
    const Bracket distance = triangle_distance(pair[0], pair[1]).distance;
    ASSERT_NO_FATAL_FAILURE(expect_bounds<double>(pair, distance));
    ASSERT_NO_FATAL_FAILURE(expect_bounds<DoubleDouble>(pair, distance));
  });
}

Triangle scaled_by(const Triangle& t, int power) {
  const double factor = std::ldexp(1.0, power);
  return {t.a * factor, t.b * factor, t.c * factor};
}

// Products of two to four lengths underflow, more or less of them.
TEST(FeatureProof, AgreesWithWholeNumbersWhereProductsUnderflow) {
  const std::vector<test::TriangleDistanceRow>& rows = test::triangle_distances();
  const std::size_t step = std::max<std::size_t>(1, rows.size() / 300);
  for (std::size_t i = 0; i < rows.size(); i += step) {
    SCOPED_TRACE(rows[i].kind + ", row " + std::to_string(i));
    for (const int power : {-178, -214, -262, -266, -268, -352, -356, -358, -534, -538}) {
      const Triangle a = scaled_by(rows[i].a, power);
      const Triangle b = scaled_by(rows[i].b, power);
      const ExactPair pair(a, b);
      for (const FeaturePair& features : kFeaturePairs) {
        ASSERT_TRUE(!prove(a, b, features).nearest || pair.squared_distance(features)) << power;
      }
    }
  }
}

}  // namespace
}  // namespace soms::detail
