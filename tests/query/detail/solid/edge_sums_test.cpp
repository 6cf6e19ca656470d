// Edges of which nothing is left, and those that stay.
#include "soms/query/detail/solid/edge_sums.h"

#include <gtest/gtest.h>

#include <vector>

namespace soms {
namespace {

using detail::CutKind;
using detail::EdgeSums;
using detail::PlanarEdge;

constexpr Vec3 kP{1, 2, 3};
constexpr Vec3 kQ{1, 2, 4};
constexpr Vec3 kR{0, 0, 0};

TEST(EdgeSums, TwoTrianglesThatHaveAnEdgeInCommonLeaveNothingOfIt) {
  EdgeSums sums;
  sums.add(kP, kQ, 0, CutKind::coplanar);
  sums.add(kQ, kR, 0, CutKind::coplanar);
  sums.add(kQ, kP, 0, CutKind::coplanar);
  sums.add(Vec3{-0.0, 0, -0.0}, kR, 0, CutKind::coplanar);  // of no length
  const std::vector<PlanarEdge> odd = sums.odd();
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_EQ(odd[0].from, kR);
  EXPECT_EQ(odd[0].to, kQ);
}

TEST(EdgeSums, ZerosOfBothSignsAreOnePoint) {
  EdgeSums sums;
  sums.add(kR, kQ, 1, CutKind::above);
  sums.add(kQ, {-0.0, 0, -0.0}, 1, CutKind::above);
  EXPECT_TRUE(sums.odd().empty());
}

TEST(EdgeSums, KeepEdgesThatChangeAnything) {
  EdgeSums rim;  // of a face, where a wall stands on it
  rim.add(kP, kQ, 0, CutKind::coplanar);
  rim.add(kP, kQ, 0, CutKind::below);
  EXPECT_EQ(rim.odd().size(), 1U);
  EdgeSums two_bodies;
  two_bodies.add(kP, kQ, 0, CutKind::coplanar);
  two_bodies.add(kP, kQ, 1, CutKind::coplanar);
  EXPECT_EQ(two_bodies.odd().size(), 1U);
  EdgeSums three;
  three.add(kP, kQ, 0, CutKind::coplanar);
  three.add(kQ, kP, 0, CutKind::coplanar);
  three.add(kP, kQ, 0, CutKind::coplanar);
  EXPECT_EQ(three.odd().size(), 1U);
}

}  // namespace
}  // namespace soms
