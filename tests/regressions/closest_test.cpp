// Faults that users of other libraries reported, as far as they speak of nearest points of a mesh:
// one test a report. An id is never used again.
#include "soms/query/closest.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/print.h"
#include "soms/tree/rule/rules.h"

#include "tests/query/overlap_inputs.h"
#include "tests/regressions/bodies.h"
#include "tests/support/allocation.h"
#include "tests/support/bodies.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/closest_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

/// What brute force says of a point, turned, scaled, by every rule and layout.
void expect_as_brute_force(const Mesh& mesh, const Vec3& point) {
  for (const Pose& turn : test::cube_rotations()) {
    ASSERT_EQ(test::first_fault_of_point(Body(mesh, turn), turn.apply(point)), "");
  }
  for (int k = -40; k <= 40; k += 10) {
    const double factor = std::ldexp(1.0, k);
    const Body scaled(test::mapped(mesh, [&](const Vec3& v) { return v * factor; }));
    ASSERT_EQ(test::first_fault_of_point(scaled, point * factor), "");
  }
  for (const RuleEntry& rule : rules()) {
    for (const Layout layout : {Layout::wide, Layout::compact}) {
      const Body built(Shape(mesh, {.build = {.rule = rule.rule}, .layout = layout}));
      ASSERT_EQ(test::first_fault_of_point(built, point), "");
    }
  }
}

TEST(Regression, R26TheClosestPointLiesOnTheNamedTriangle) {
  test::for_each_case("regression/R26-closest", 50, [&](Rng& rng) {
    const Body body(test::awkward_mesh(rng, 60));
    const Vec3 p{rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
    const Closest answer = closest(body, p);
    ASSERT_TRUE(answer.triangle);
    ASSERT_EQ(point_distance(p, body.shape.mesh().triangle(*answer.triangle)),
              (PointDistance{answer.distance, answer.point, answer.feature}));
    ASSERT_EQ(test::fault_of_points(body, test::body_of({p, p, p}), {*answer.triangle, 0},
                                    answer.point, p, answer.distance),
              "");
  });
}

TEST(Regression, R29ATriangleWithoutAreaIsAsFarAsItsSegment) {
  const Vec3 a{2.27699995, -7.9000001, 16.3180008};
  const Vec3 b{-0.569999993, -8.10000038, 16.6070004};
  const Vec3 p{1.10000002, -7.9000001, 16.5879993};
  const Mesh mesh = test::soup_body({{a, b, b}});
  const Closest answer = closest(Body(mesh), p);
  EXPECT_NEAR(answer.distance.lower, 0.17147826590, 1e-11);
  EXPECT_EQ(answer.feature, TriangleFeature::edge);
  for (const Triangle& t : test::corner_orders({a, b, b})) {
    EXPECT_EQ(closest(test::body_of(t), p).distance, answer.distance);
  }
  expect_as_brute_force(mesh, p);
}

TEST(Regression, R30PointsOnTheSurfaceHaveADistanceOfZero) {
  const Mesh& box = test::unit_box();
  const Closest on = closest(Body(box), {0, 0.5, 0.5});
  EXPECT_EQ(on.distance, (Bracket{0, 0}));
  EXPECT_EQ(on.point, (Vec3{0, 0.5, 0.5}));
  const Closest beside = closest(Body(box), {0x1p-60, 0.5, 0.5});
  EXPECT_EQ(beside.distance, (Bracket{0x1p-60, 0x1p-60}));
  EXPECT_EQ(beside.point, (Vec3{0, 0.5, 0.5}));
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner{static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1),
                      static_cast<double>(k >> 2 & 1)};
    const Closest answer = closest(Body(box), corner);
    EXPECT_EQ(answer.distance, (Bracket{0, 0}));
    EXPECT_EQ(answer.point, corner);
    EXPECT_EQ(answer.feature, TriangleFeature::vertex);
    expect_as_brute_force(box, corner);
  }
  expect_as_brute_force(box, {0, 0.5, 0.5});
  expect_as_brute_force(box, {0x1p-60, 0.5, 0.5});
}

TEST(Regression, R104AMillionPointsTakeTheMemoryOfTheirAnswers) {
  const Body knot(generate_knot(10000));
  Rng rng(104);
  std::vector<Vec3> points(test::kSlowBuild ? 100'000 : 1'000'000);
  for (Vec3& p : points) {
    p = {rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)};
  }
  constexpr std::uint64_t kAnswer = 2 * sizeof(double) + sizeof(std::optional<TriangleId>) +
                                    sizeof(Vec3) + 2 + sizeof(Coverage) + sizeof(Cost);
  const test::AllocationWatch watch;
  const ClosestBatch batch = closest(knot, points);
  EXPECT_LE(watch.peak(), kAnswer * points.size() + (std::uint64_t{64} << 20));
  EXPECT_EQ(batch.size(), points.size());
}

}  // namespace
}  // namespace soms
