#include "soms/query/reference/winding.h"

#include "soms/base/error.h"

#include "tests/support/bodies.h"

#include <gtest/gtest.h>

namespace soms {
namespace {

using reference::winding_by_brute_force;

bool holds(const Bracket& bracket, double number) {
  return bracket.lower <= number && number <= bracket.upper;
}

TEST(WindingByBruteForce, KnowsTheBox) {
  const Body box(test::box_body({0, 0, 0}, {1, 1, 1}, 2));
  EXPECT_TRUE(holds(winding_by_brute_force(box, Vec3{0.5, 0.3, 0.2}), 1));
  EXPECT_TRUE(holds(winding_by_brute_force(box, Vec3{2, 0.3, 0.2}), 0));
  EXPECT_LT(winding_by_brute_force(box, Vec3{2, 0.3, 0.2}).upper, 1e-14);
  EXPECT_EQ(winding_by_brute_force(Body{}, Vec3{1, 2, 3}).upper, 5e-324);
}

// An octant is an eighth of all directions.
TEST(WindingByBruteForce, KnowsAnOctant) {
  const Body octant(test::soup_body({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}));
  const Bracket number = winding_by_brute_force(octant, Vec3{0, 0, 0});
  EXPECT_TRUE(holds(number, 0.125));
  EXPECT_LT(number.upper - number.lower, 1e-15);
}

TEST(WindingByBruteForce, HoldsBothSidesOnTheSurface) {
  const Body box(test::box_body({0, 0, 0}, {1, 1, 1}, 3));
  const Bracket face = winding_by_brute_force(box, Vec3{1, 0.4, 0.45});
  EXPECT_TRUE(holds(face, 0));
  EXPECT_TRUE(holds(face, 1));
  EXPECT_LT(face.upper - face.lower, 1 + 1e-12);
}

TEST(WindingByBruteForce, RefusesPoses) {
  Pose skewed;
  skewed.m[1] = 0.5;
  EXPECT_THROW(static_cast<void>(winding_by_brute_force(
                   Body(test::box_body({0, 0, 0}, {1, 1, 1}), skewed), Vec3{})),
               Error);
}

}  // namespace
}  // namespace soms
