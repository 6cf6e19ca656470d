// Faults of threads in the peers' trackers; the whole suite runs under ThreadSanitizer (make tsan).
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/scene/scene.h"
#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include <gtest/gtest.h>

#include <latch>
#include <thread>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// What one thread makes and asks, as hashes: trees, layouts, pairs, a step of a scene.
using Work = std::vector<std::uint64_t>;

Work work_of(std::size_t k, const Shape& shared) {
  const Rule rule = rules()[k % rules().size()].rule;
  const Limits limits{.threads = k % 2 == 0 ? 1 : 3};
  const ShapeOptions options{.build = {.rule = rule}, .keep_tree = true};
  const Body body(Shape(generate_knot(200 + 2 * (k % 4)), options, limits),
                  Pose::translation(0.1 * static_cast<double>(k % 4), 0, 0));
  Work work{tree_hash(*body.shape.tree()), tree_hash(build(shared.mesh(), options.build, limits))};
  const Overlap answer = overlap(body, Body(shared), {}, limits);
  work.insert(work.end(), {answer.hash(), answer.cost.node_tests, answer.cost.triangle_tests});
  const std::vector<Pose> poses(20, body.pose);
  const OverlapBatch batch = overlap(body.shape, poses, Body(shared), {}, limits);
  work.insert(work.end(), {batch.pairs.size(), batch.cost.node_tests});
  Scene scene;
  scene.add_environment(Body(shared));
  for (std::size_t i = 0; i < 3; ++i) {
    scene.add_mover(body);
  }
  work.push_back(scene.step({}, limits).hash());
  return work;
}

// A table filled by whoever comes first (flexible-collision-library/fcl#253), boxes that grow in a
// race (shinjiogaki/bvh#3), a pool that hangs with two builds (madmann91/bvh#111).
TEST(ThreadRegressions, R85SixtyFourThreadsBuildAndQueryAtOnce) {
  constexpr std::size_t kThreads = 64;
  std::vector<Work> found(kThreads);
  const Shape shared(generate_knot(300));
  {
    std::latch start(kThreads);
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < kThreads; ++k) {
      threads.emplace_back([&, k] {
        start.arrive_and_wait();
        found[k] = work_of(k, shared);
      });
    }
  }
  for (std::size_t k = 0; k < kThreads; ++k) {
    EXPECT_EQ(found[k], work_of(k, shared)) << "thread " << k;
  }
  EXPECT_NE(found[0], found[1]);
}

}  // namespace
}  // namespace soms
