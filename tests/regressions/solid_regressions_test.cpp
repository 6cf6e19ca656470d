// Faults that users of other libraries reported, as far as they speak of bodies and not of surfaces
// alone: each under all variations. An id is never used again.
#include "soms/generate/shapes.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/solid.h"

#include "tests/regressions/bodies.h"
#include "tests/regressions/variations.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::mapped;
using test::unit_box;

Relation of_exchanged(Relation relation) {
  return relation == Relation::a_in_b   ? Relation::b_in_a
         : relation == Relation::b_in_a ? Relation::a_in_b
                                        : relation;
}

void expect_relation(const Mesh& a, const Mesh& b, Relation expected) {
  test::for_each_variation(a, b, [&](const test::Variation& variation) {
    const Solid answer = solid(variation.a, variation.b, variation.limits);
    EXPECT_EQ(answer.relation, variation.exchanged ? of_exchanged(expected) : expected)
        << variation.what;
  });
  const std::vector<Pose> poses = test::poses_around(a);
  const SolidBatch batch = solid(Shape(a), poses, Body(b));
  EXPECT_EQ(batch.relation[test::kPlaceInBatch], expected) << "in a batch";
}

TEST(Regression, R01FlushWallsThatRunIntoEachOtherCross) {
  expect_relation(unit_box(), box_body({0.95, 0, 0}, {1.95, 1, 1}), Relation::crossing);
  expect_relation(box_body({0, 0, 0}, {4.05, 0.2, 3}), box_body({4, 0, 0}, {4.2, 4, 3}),
                  Relation::crossing);
}

TEST(Regression, R02ASharedFaceIsATouch) {
  const auto beside = [](double shift) { return box_body({1 + shift, 0, 0}, {2 + shift, 1, 1}); };
  expect_relation(unit_box(), beside(-0x1p-30), Relation::crossing);
  expect_relation(unit_box(), beside(0), Relation::touching);
  expect_relation(unit_box(), beside(0x1p-30), Relation::clear);
}

TEST(Regression, R03SkewedMembersThatShareAFaceTouch) {
  const auto turn = [](const Vec3& v) {
    return Vec3{3 * v.x - 4 * v.y, 4 * v.x + 3 * v.y, 5 * v.z};
  };
  const Mesh first = mapped(unit_box(), turn);
  expect_relation(first, mapped(box_body({1, 0, 0}, {2, 1, 1}), turn), Relation::touching);
  expect_relation(first, mapped(box_body({1 - 0x1p-20, 0, 0}, {2 - 0x1p-20, 1, 1}), turn),
                  Relation::crossing);
}

TEST(Regression, R09OverlapAndSolidAgreeAtAKissingContact) {
  test::for_each_case("regression/R09-solid", 12, [](Rng& rng) {
    test::KissingCube kiss = test::kissing_cube(rng);
    const double start = kiss.pose.m[3];
    for (int ulps = -8; ulps <= 8; ++ulps) {
      kiss.pose.m[3] = start + ulps * 0x1p-54;
      const Mesh moved = mapped(kiss.cube, [&](const Vec3& v) { return kiss.pose.apply(v); });
      const double corner = bounds(moved).lower.x;
      const Relation expected = corner > 0.25    ? Relation::clear
                                : corner == 0.25 ? Relation::touching
                                                 : Relation::crossing;
      const Solid answer = solid(Body(kiss.cube, kiss.pose), Body(kiss.wall));
      ASSERT_EQ(answer.relation, expected) << ulps;
      ASSERT_EQ(answer.surfaces_meet, overlap(Body(kiss.cube, kiss.pose), Body(kiss.wall)).any);
    }
  });
}

TEST(Regression, R14ABodyAndItsCopyAreTheSame) {
  const Mesh knot = generate_knot(120);
  Mesh copy = knot;
  std::reverse(copy.triangles.begin(), copy.triangles.end());
  expect_relation(unit_box(), box_body({0, 0, 0}, {1, 1, 1}, 2), Relation::same);
  EXPECT_EQ(solid(Body(knot), Body(copy)).relation, Relation::same);
}

TEST(Regression, R17ABodyInsideAnotherIsFound) {
  const Mesh inner = box_body({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
  expect_relation(inner, box_body({-5, -5, -5}, {5, 5, 5}), Relation::a_in_b);
  const std::vector<Body> nested{
      Body(mapped(inner,
                  [](const Vec3& v) {
                    return v - Vec3{0, 0, 5};
                  })),
      Body(mapped(generate_sphere(480), [](const Vec3& v) { return 20 * v; })),
      Body(box_body({-60, -60, -60}, {60, 60, 60}))};
  for (std::size_t i = 0; i < nested.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Solid answer = solid(nested[j], nested[i]);
      EXPECT_EQ(answer.relation, Relation::a_in_b);
      EXPECT_FALSE(answer.surfaces_meet);
      EXPECT_EQ(solid(nested[i], nested[j]).relation, Relation::b_in_a);
    }
  }
}

}  // namespace
}  // namespace soms
