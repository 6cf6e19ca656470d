// A fault of answers that were other bits elsewhere; its number as in the list of regressions.
#include "soms/base/hash.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace soms {
namespace {

/// A rotation and a shift, by operations that IEEE 754 rounds in one way only.
Pose next_pose(Rng& rng) {
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = rng.uniform(-1, 1);
    square += x * x;
  }
  const double size = std::sqrt(square);
  return Pose::from_quaternion(q[0] / size, q[1] / size, q[2] / size, q[3] / size,
                               {rng.uniform(-2, 2), rng.uniform(-1, 1), 0});
}

// The same numbers stand here for every processor, compiler and optimization; `make arm64` runs
// this test too, and tests/golden has many more of them.
TEST(Regression, R86TreesAndAnswersAreTheSameBitsOnEveryMachine) {
  const Mesh knot = generate_knot(600);
  Fnv1a trees;
  for (const RuleEntry& rule : rules()) {
    if (rule.rule != Rule::quick) {
      trees.add(tree_hash(build(knot, {.rule = rule.rule})));
    }
  }
  EXPECT_EQ(trees.value(), 6086221505690445464U);
  trees.add(tree_hash(build(knot, {.rule = Rule::quick})));
  EXPECT_EQ(trees.value(), 8400234780120160445U);
  const Body fixed{knot};
  Rng rng(86);
  Fnv1a answers;
  std::uint64_t pairs = 0;
  for (int i = 0; i < 200; ++i) {
    const Overlap answer = overlap(Body(fixed.shape, next_pose(rng)), fixed);
    answers.add(answer.hash());
    answers.add(answer.cost.node_tests);
    answers.add(answer.cost.triangle_tests);
    pairs += answer.pairs.size();
  }
  EXPECT_EQ(answers.value(), 2505427054921888957U);
  EXPECT_EQ(pairs, 19714U);
}

}  // namespace
}  // namespace soms
