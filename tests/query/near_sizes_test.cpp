// A small body beside a large one: near it, beyond its size, and where poses round to more than
// either.
#include "soms/generate/shapes.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <cmath>

namespace soms {
namespace {

void expect_true_of_both(const Body& a, const Body& b) {
  ASSERT_EQ(test::first_fault(a, b), "");
}

/// A ball of about 1, and one a thousandth to a tenth of it.
test::Two ball_and_small_one(Rng& rng, double distance, std::uint64_t triangles) {
  const double size = std::exp2(-rng.uniform(4, 10));
  const Mesh ball = generate_sphere(triangles);
  const Mesh small = test::placed(generate_sphere(24), size, {});
  const Vec3 way{rng.uniform(-1, 1), rng.uniform(-1, 1), 1};
  const Pose pose = test::moving(test::awkward_rotation(rng), {},
                                 way * ((1 + size + distance) / std::sqrt(dot(way, way))));
  return {Body(small, pose), Body(ball, test::awkward_rotation(rng))};
}

TEST(NearSizes, ASmallBodyNearALargeOneAnswersAsBruteForce) {
  test::for_each_case("near-sizes/near", test::some_of(40), [](Rng& rng) {
    const test::Two two = ball_and_small_one(rng, std::exp2(-rng.uniform(2, 16)), 360);
    ASSERT_NO_FATAL_FAILURE(expect_true_of_both(two.a, two.b));
  });
}

TEST(NearSizes, ASmallBodyFarFromALargeOneAnswersAsBruteForce) {
  test::for_each_case("near-sizes/far", test::some_of(20), [](Rng& rng) {
    const test::Two two = ball_and_small_one(rng, std::exp2(rng.uniform(6, 30)), 360);
    ASSERT_NO_FATAL_FAILURE(expect_true_of_both(two.a, two.b));
  });
}

// Of the triangles on one side of each ball few matter, and the pairs of these differ by less than
// where the bodies lie is rounded, or by more.
TEST(NearSizes, FarBodiesOfManyTrianglesAnswerAsBruteForce) {
  test::for_each_case("near-sizes/many-far", test::some_of(40), [](Rng& rng) {
    const double distance = std::exp2(rng.uniform(6, 40));
    const Vec3 place = Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)} *
                       std::exp2(rng.uniform(0, 52));
    const Vec3 way{rng.uniform(-1, 1), rng.uniform(-1, 1), 1};
    const BuildOptions large_leaves{.rule = Rule::object_median, .per_leaf = 30};
    const ShapeOptions options{.build = rng.below(2) == 0 ? large_leaves : BuildOptions()};
    const Body a(Shape(generate_sphere(120), options),
                 test::moving(test::awkward_rotation(rng), {}, place));
    const Body b(Shape(generate_sphere(120), options),
                 test::moving(test::awkward_rotation(rng), {}, place + way * distance));
    ASSERT_NO_FATAL_FAILURE(expect_true_of_both(a, b));
  });
}

// Squares of such distances are below the least normal double, or 0.
TEST(NearSizes, FarBodiesWhoseSquaredDistanceUnderflowsAnswerAsBruteForce) {
  test::for_each_case("near-sizes/underflow", test::some_of(150), [](Rng& rng) {
    const double distance = std::exp2(-rng.uniform(500, 1070));
    const double size = distance * std::exp2(-rng.uniform(6, 12));
    const Pose pose = test::moving(test::awkward_rotation(rng), {},
                                   Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), 1} * distance);
    const Body a(test::placed(generate_sphere(60), size, {}), pose);
    const Body b(test::placed(generate_sphere(24), size, {}), test::awkward_rotation(rng));
    ASSERT_NO_FATAL_FAILURE(expect_true_of_both(a, b));
  });
}

// Nothing is known of distances then but what is decided exactly.
TEST(NearSizes, BodiesThatRoundingOutweighsAnswerAsBruteForce) {
  test::for_each_case("near-sizes/rounding", test::some_of(20), [](Rng& rng) {
    const double place = std::exp2(rng.uniform(90, 290));
    const test::Two two = ball_and_small_one(rng, 1, 24);
    Pose far = two.a.pose;
    far.m[3] = place;
    far.m[7] = rng.below(2) == 0 ? 0 : place * std::exp2(-rng.uniform(0, 60));
    Pose other = two.b.pose;
    other.m[3] = rng.below(2) == 0 ? place : place * (1 + 0x1p-50);
    ASSERT_NO_FATAL_FAILURE(expect_true_of_both(Body(two.a.shape, far), Body(two.b.shape, other)));
  });
}

}  // namespace
}  // namespace soms
