// Faults that users of other libraries reported of margins, tried on ours; ids as in the design's
// list of regressions.
#include "soms/query/distance.h"
#include "soms/query/within.h"
#include "soms/scene/scene.h"

#include "tests/regressions/cube.h"
#include "tests/support/support.h"

#include <cstdint>
#include <vector>

namespace soms {

namespace {

constexpr double kMargin = 3;

/// Three cubes 2 m from a fourth, on three of its sides, all turned and shifted by `pose`.
std::vector<Body> four_cubes(const Pose& pose, const Shape& cube) {
  std::vector<Body> bodies;
  for (const Vec3& at : {Vec3{0, 0, 0}, {3, 0, 0}, {0, -3, 0}, {0, 0, 3}}) {
    bodies.emplace_back(cube, pose * Pose::translation(at.x, at.y, at.z));
  }
  return bodies;
}

/// The gap of two bodies, queried by themselves.
template <typename Gap>
Gap gap_of(MoverId a, const Body& first, std::uint32_t b, const Body& second) {
  const Distance answer = distance(first, second);
  return {a,
          b,
          answer.triangles->a,
          answer.triangles->b,
          answer.distance,
          answer.point_a,
          answer.point_b};
}

// The fourth is a part of the environment, where the other three are movers, and a mover among
// movers; the three are 2 * sqrt(2) from each other, and share a group.
void expect_the_same_three_pairs(const std::vector<Body>& bodies) {
  Scene with_environment;
  const EnvironmentId fourth = with_environment.add_environment(bodies[0]);
  Scene of_movers;
  of_movers.add_mover(bodies[0]);
  for (std::size_t k = 1; k < bodies.size(); ++k) {
    ASSERT_TRUE(within(bodies[0], bodies[k], kMargin).within);
    with_environment.add_mover(bodies[k], 1);
    of_movers.add_mover(bodies[k], 1);
  }
  for (const bool coherent : {true, false}) {
    const StepOptions options{.coherent = coherent, .clearance = kMargin};
    const StepReport still = with_environment.step(options);
    const StepReport moving = of_movers.step(options);
    ASSERT_EQ(still.environment_gaps.size(), 3U);
    EXPECT_TRUE(still.mover_gaps.empty());
    ASSERT_EQ(moving.mover_gaps.size(), 3U);
    for (MoverId k = 0; k < 3; ++k) {
      EXPECT_EQ(moving.mover_gaps[k], gap_of<MoverGap>(0, bodies[0], k + 1, bodies[k + 1]));
      const EnvironmentGap& gap = still.environment_gaps[k];
      EXPECT_EQ(gap, gap_of<EnvironmentGap>(k, bodies[k + 1], fourth, bodies[0]));
      EXPECT_NEAR(gap.distance.lower, 2, 1e-8);  // vertices at 1e7 are rounded to 2e-9
    }
  }
}

// R33: the pair test honored a margin, and the tree of bodies dropped the pairs before it.
TEST(ClearanceRegressions, R33TheBroadPhaseHonorsTheMarginOfThePairTest) {
  const Shape cube(test::cube());
  test::for_each_case("regressions/r33", 20, [&](Rng& rng) {
    const double offset = rng.below(4) == 0 ? 0 : 1e7;
    const Vec3 shift{offset, rng.uniform(-1, 1) * offset, rng.uniform(-1, 1) * offset};
    const Pose turned = Pose::from_quaternion(0.5, 0.5, 0.1, 0.7, {0, 0, 0});
    const Pose there = Pose::translation(shift.x, shift.y, shift.z);
    for (const Pose& pose : {there, there * turned}) {
      expect_the_same_three_pairs(four_cubes(pose, cube));
    }
  });
}

}  // namespace

}  // namespace soms
