#include "soms/thesis/fast_steps.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

namespace soms::thesis {
namespace {

/// Two bodies for each way in which a traversal begins and goes on.
std::vector<std::pair<Body, Body>> couples() {
  const Shape knot(generate_knot(600));
  const Shape large(generate_sphere(5'000));
  const Shape small(test::box_body({-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}));
  const Pose beside = Pose::translation(0.4, 0.1, 0);
  return {{Body(knot), Body(knot, beside)},
          {Body(knot, beside), Body(large)},
          {Body(large), Body(knot, beside)},
          {Body(large), Body(small, Pose::translation(1, 0, 0))},
          {Body(small, Pose::translation(0, 1, 0)), Body(large)},
          {Body(knot), Body(knot, Pose::translation(100, 0, 0))}};
}

bool holds(const Body& body, std::uint32_t block, TriangleId id) {
  const TriangleBlock& triangles = body.shape.layout().blocks()[block];
  return std::find(triangles.id.begin(), triangles.id.begin() + triangles.count, id) !=
         triangles.id.begin() + triangles.count;
}

TEST(FastSteps, AreTheTestsThatAQueryCounts) {
  for (const auto& [a, b] : couples()) {
    const Overlap answer = overlap(a, b, {}, {.threads = 1});
    const FastSteps steps = fast_steps(a, b);
    EXPECT_FALSE(steps.cut);
    EXPECT_EQ(steps.cost, answer.cost);
    std::uint64_t nodes = 0;
    std::uint64_t triangles = 0;
    for (const FastStep& step : steps.steps) {
      nodes += step.node_tests;
      triangles += step.triangle_tests;
    }
    EXPECT_EQ(nodes, answer.cost.node_tests);
    EXPECT_EQ(triangles, answer.cost.triangle_tests);
    EXPECT_EQ(steps.steps.front().test, FastTest::whole);
    EXPECT_EQ(steps.steps.back().found, answer.pairs.size());
  }
}

TEST(FastSteps, CompareTheLeavesOfAllThatTouches) {
  for (const auto& [a, b] : couples()) {
    const FastSteps steps = fast_steps(a, b);
    for (const auto& [i, j] : overlap(a, b).pairs) {
      EXPECT_TRUE(std::any_of(steps.steps.begin(), steps.steps.end(),
                              [&a = a, &b = b, i = i, j = j](const FastStep& s) {
                                return s.test == FastTest::leaves && holds(a, s.a, i) &&
                                       holds(b, s.b, j);
                              }))
          << i << ' ' << j;
    }
  }
}

TEST(FastSteps, TestBoxesThatThereAreAndEnterNoOthersThanMeet) {
  for (const auto& [a, b] : couples()) {
    for (const FastStep& step : fast_steps(a, b).steps) {
      if (step.test != FastTest::nodes && step.test != FastTest::larger) {
        continue;
      }
      const auto boxes = [](const Body& body, std::uint32_t node) {
        return (1U << body.shape.layout().nodes()[node].count) - 1;
      };
      EXPECT_EQ(step.boxes_a & ~boxes(a, step.a), 0U);
      EXPECT_EQ(step.boxes_b & ~boxes(b, step.b), 0U);
      EXPECT_EQ(step.boxes_a == 0 || step.boxes_b == 0, step.test == FastTest::larger);
      for (std::uint32_t bit = 0; bit < 16; ++bit) {
        const bool tested = (std::max<std::uint32_t>(step.boxes_a, 1) >> bit / 4 & 1U) != 0 &&
                            (std::max<std::uint32_t>(step.boxes_b, 1) >> bit % 4 & 1U) != 0;
        EXPECT_TRUE(tested || (step.meet >> bit & 1U) == 0);
      }
    }
  }
}

TEST(FastSteps, EndWhereEnoughWereNoted) {
  const auto [a, b] = couples().front();
  const FastSteps few = fast_steps(a, b, 10);
  EXPECT_TRUE(few.cut);
  EXPECT_GE(few.steps.size(), 10U);
  const FastSteps all = fast_steps(a, b);
  EXPECT_LT(few.steps.size(), all.steps.size());
  EXPECT_EQ(few.steps,
            std::vector(all.steps.begin(),
                        all.steps.begin() + static_cast<std::ptrdiff_t>(few.steps.size())));
  EXPECT_TRUE(fast_steps(Body(Mesh{}), b).steps.empty());
  const Shape packed(generate_knot(600), {.layout = Layout::compact});
  EXPECT_THROW((void)fast_steps(Body(packed), b), Error);
}

}  // namespace
}  // namespace soms::thesis
