// Compact layouts, queried in every way that others are: the same answers.
#include "soms/generate/shapes.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

Shape compact(const Mesh& mesh, const BuildOptions& build = {}) {
  ShapeOptions options;
  options.build = build;
  options.layout = Layout::compact;
  return Shape(mesh, options);
}

const Shape& compact_shape_of(const std::string& name) {
  static std::map<std::string, Shape> shapes;
  const auto found = shapes.find(name);
  return found != shapes.end()
             ? found->second
             : shapes.emplace(name, compact(*test::truth_mesh(name))).first->second;
}

/// Every mode, of two bodies that overlap in `pairs`.
void expect_answers(const Body& a, const Body& b, const std::vector<TrianglePair>& pairs) {
  const Overlap all = overlap(a, b);
  ASSERT_EQ(all.pairs, pairs);
  ASSERT_EQ(all.any, !pairs.empty());
  ASSERT_EQ(all.coverage, Coverage::complete);
  const Overlap any = overlap(a, b, {.mode = OverlapMode::any});
  ASSERT_EQ(any.any, !pairs.empty());
  const Overlap first = overlap(a, b, {.mode = OverlapMode::first});
  ASSERT_EQ(first.pairs.empty(), pairs.empty());
  if (!pairs.empty()) {
    ASSERT_EQ(first.pairs.front(), pairs.front());
    ASSERT_TRUE(std::binary_search(pairs.begin(), pairs.end(), any.pairs.front()));
  }
  const Overlap limited = overlap(a, b, {.limit = 5});
  ASSERT_EQ(limited.pairs.size(), std::min<std::size_t>(5, pairs.size()));
  ASSERT_EQ(limited.coverage, pairs.size() > 5 ? Coverage::cut : Coverage::complete);
  const Overlap threaded = overlap(a, b, {}, {.threads = 2});
  ASSERT_EQ(threaded.pairs, pairs);
  ASSERT_EQ(threaded.cost, all.cost);
}

TEST(CompactSource, HoldsForAllCasesOfTheTruthSet) {
  const auto cases = test::truth_cases(test::Models::own);
  ASSERT_EQ(cases.size(), 3780U);
  for (const test::TruthCase& truth : cases) {
    SCOPED_TRACE("case " + std::to_string(truth.number) + ", " + truth.kind);
    const Body a(compact_shape_of(truth.mesh_a), truth.pose_a);
    const Body b(compact_shape_of(truth.mesh_b), truth.pose_b);
    const Overlap answer = overlap(a, b);
    ASSERT_EQ(answer.any, truth.overlap);
    ASSERT_EQ(answer.pairs.size(), truth.count);
    ASSERT_EQ(answer.hash(), truth.hash);
    ASSERT_EQ(overlap(a, b, {.mode = OverlapMode::any}).any, truth.overlap);
  }
}

// Each side of either layout, in every mode, alone and in batches.
TEST(CompactSource, AnswersAsBruteForceWithEitherLayoutOnEitherSide) {
  test::for_each_case("compact_source/answers", 400, [](Rng& rng) {
    const double scale = std::exp2(rng.below(3) == 0 ? rng.uniform(-200, 200) : 0);
    const Vec3 far = rng.below(3) == 0 ? scale * Vec3{1e7, -3e6, 11} : Vec3{};
    const Mesh mesh_a = test::placed(test::awkward_mesh(rng, 120), scale, far);
    const Mesh mesh_b = test::placed(test::awkward_mesh(rng, 120), scale, {});
    const Pose pose = test::moving(test::awkward_rotation(rng), test::point_in(rng, bounds(mesh_a)),
                                   test::point_in(rng, bounds(mesh_b)));
    const auto pairs = reference::overlap(mesh_a, pose, mesh_b, {}).pairs;
    const BuildOptions build = test::awkward_options(rng);
    const Body small_a{compact(mesh_a, build), pose};
    const Body small_b{compact(mesh_b, build)};
    const Body large_a{Shape(mesh_a), pose};
    const Body large_b{Shape(mesh_b)};
    ASSERT_NO_FATAL_FAILURE(expect_answers(small_a, small_b, pairs));
    ASSERT_NO_FATAL_FAILURE(expect_answers(small_a, large_b, pairs));
    ASSERT_NO_FATAL_FAILURE(expect_answers(large_a, small_b, pairs));
    const std::vector<Pose> poses{pose, Pose{}, pose};
    for (const int threads : {1, 2}) {
      const OverlapBatch batch = overlap(small_a.shape, poses, small_b, {}, {.threads = threads});
      for (const std::size_t k : {0U, 2U}) {
        const auto found = batch.pairs_of(k);
        ASSERT_TRUE(std::equal(found.begin(), found.end(), pairs.begin(), pairs.end()));
        ASSERT_EQ(batch.costs[k], overlap(small_a, small_b).cost);
      }
    }
  });
}

TEST(CompactSource, OverlapsNothingWithAnEmptyMesh) {
  EXPECT_FALSE(overlap(Body{compact({})}, Body{compact(generate_sphere(80))}).any);
}

}  // namespace
}  // namespace soms
