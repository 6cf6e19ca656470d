#include "soms/geometry/detail/axis_gap.h"

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/feature_proof.h"
#include "soms/geometry/detail/pair_distance.h"
#include "soms/geometry/triangle_overlap.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <compare>
#include <cstddef>
#include <limits>

namespace soms::detail {
namespace {

const DoubleDouble kMost = std::numeric_limits<double>::infinity();

/// Corners of few whole coordinates: many triangles have edges and faces along axes.
Triangle lattice_triangle(Rng& rng) {
  std::array<Vec3, 3> corners;
  const std::size_t flat = rng.below(4);
  const double level = static_cast<double>(rng.below(9));
  for (Vec3& v : corners) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      v[axis] = axis == flat ? level : static_cast<double>(rng.below(9));
    }
  }
  return {corners[0], corners[1], corners[2]};
}

bool is_zero(const Vec3& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

TEST(AxisGap, IsTheDistanceOfWholeNumbers) {
  std::size_t found = 0;
  std::size_t refused = 0;
  test::for_each_case("axis-gap/lattice", 4000, [&](Rng& rng) {
    const Triangle a = lattice_triangle(rng);
    const Triangle b = lattice_triangle(rng);
    if (triangles_overlap(a, b)) {
      ASSERT_FALSE(axis_gap(a, b, 0.0, kMost));
      return;
    }
    const ExactDistance exact = exact_distance(ExactPair(a, b), {0, 0});
    const std::optional<DoubleDouble> gap = axis_gap(a, b, 0.0, kMost);
    ASSERT_EQ(gap, axis_gap(b, a, 0.0, kMost));
    if (!gap) {
      ++refused;
      return;
    }
    ++found;
    ASSERT_EQ(gap->low, 0);
    ASSERT_EQ(compare(exact.squared, gap->high), std::strong_ordering::equal);
  });
  EXPECT_GT(found, 500U);
  EXPECT_GT(refused, 500U);
}

TEST(AxisGap, IsADifferenceWithoutError) {
  const Triangle floor{{-1, -1, 0x1p-60}, {4, -1, 0x1p-60}, {0, 4, 0x1p-60}};
  const Triangle above{{0, 0, 1}, {1, 0, 3}, {0, 1, 2}};
  const std::optional<DoubleDouble> gap = axis_gap(floor, above, 0.0, kMost);
  ASSERT_TRUE(gap);
  EXPECT_EQ(*gap, (DoubleDouble{1, -0x1p-60}));
  EXPECT_FALSE(axis_gap(floor, above, 1.0, kMost));
  EXPECT_FALSE(axis_gap(floor, above, 0.0, 0.5));
}

// Wheels stand above the two triangles of a floor, or of a ramp: all are as near.
TEST(PairDistance, TiesAboveFloorsAndRampsNeedNoWholeNumbers) {
  for (const double slope : {0.0, 0.1}) {
    const auto ground = [&](double x, double y) { return Vec3{x, y, slope * y}; };
    const Triangle first{ground(0, 0), ground(8, 0), ground(8, 8)};
    const Vec3 tip{5, 2, 0.7};
    const Vec3 beside = tip + Vec3{1.25, 0, 0};
    PairDistance from_tip({tip, tip + Vec3{-1, 1, 1}, tip + Vec3{1, 1, 1}}, first);
    PairDistance from_beside({beside, beside + Vec3{-1, 1, 1}, beside + Vec3{1, 1, 1}}, first);
    PairDistance from_edge({tip, beside, tip + Vec3{0, 1, 1}}, first);
    EXPECT_EQ(from_tip.compare(from_beside), std::strong_ordering::equal) << slope;
    EXPECT_EQ(from_edge.compare(from_beside), std::strong_ordering::equal) << slope;
    EXPECT_EQ(from_tip.exact_tests() + from_beside.exact_tests() + from_edge.exact_tests(), 0U);
  }
}

// Tips at one height above faces whose heights differ by less than doubles tell.
TEST(PairDistance, CornersAsHighAboveUnlikeFacesDoNotTie) {
  const Triangle low{{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  const Triangle high{{-4, -4, 0x1p-60}, {4, -4, 0x1p-60}, {0, 4, 0x1p-60}};
  const Vec3 tip{0, -1, 1};
  const Vec3 beside{0.5, -1, 1};
  PairDistance from_tip({tip, tip + Vec3{1, 1, 1}, tip + Vec3{-1, 1, 1}}, low);
  PairDistance from_beside({beside, beside + Vec3{1, 1, 1}, beside + Vec3{-1, 1, 1}}, high);
  EXPECT_EQ(from_tip.compare(from_beside), std::strong_ordering::greater);
  EXPECT_EQ(from_beside.compare(from_tip), std::strong_ordering::less);
}

// Whatever is found to tie, or not to, is what whole numbers say.
TEST(PairDistance, ComparesPairsOfLatticesAsWholeNumbersDo) {
  std::size_t ties = 0;
  test::for_each_case("pair-distance/lattice", test::kSlowBuild ? 4000 : 20000, [&](Rng& rng) {
    const Triangle face = lattice_triangle(rng);
    const Triangle other_face = rng.below(2) == 0 ? face : lattice_triangle(rng);
    const Triangle s = lattice_triangle(rng);
    const Triangle t = lattice_triangle(rng);
    if (triangles_overlap(face, s) || triangles_overlap(other_face, t)) {
      return;
    }
    PairDistance here(s, face);
    PairDistance there(t, other_face);
    const std::strong_ordering order =
        compare(exact_distance(ExactPair(s, face), {0, 0}).squared,
                exact_distance(ExactPair(t, other_face), {0, 0}).squared);
    ASSERT_EQ(here.compare(there), order);
    PairDistance turned(face, s);
    PairDistance other(other_face, t);
    ASSERT_EQ(turned.compare(other), order);
    ties += order == std::strong_ordering::equal ? 1U : 0U;
  });
  EXPECT_GT(ties, test::kSlowBuild ? 3U : 20U);
}

TEST(FeatureProof, VectorsAreSurelyCoplanarWhereEachProductHasAFactorOfZero) {
  test::for_each_case("feature-proof/coplanar", 3000, [](Rng& rng) {
    std::array<Vec3, 3> v;
    for (Vec3& vector : v) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        vector[axis] = rng.below(2) == 0 ? 0 : rng.uniform(1, 2);
      }
    }
    // No two products of random numbers cancel out.
    const double determinant = dot(cross(v[0], v[1]), v[2]);
    if (surely_coplanar(v[0], v[1], v[2])) {
      ASSERT_EQ(determinant, 0);
    } else if (!is_zero(cross(v[0], v[1]))) {
      ASSERT_NE(determinant, 0);
    }
  });
}

}  // namespace
}  // namespace soms::detail
