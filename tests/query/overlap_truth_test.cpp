// The truth set, queried for the default traversal in every way it can be queried.
#include "soms/query/overlap.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/support/truth/truth.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Shapes of the set's meshes, built once.
const Shape& shape_of(const std::string& name) {
  static std::map<std::string, Shape> shapes;
  const auto found = shapes.find(name);
  return found != shapes.end() ? found->second
                               : shapes.emplace(name, Shape(*test::truth_mesh(name))).first->second;
}

void check_case(const test::TruthCase& truth, const Overlap& answer) {
  ASSERT_EQ(answer.any, truth.overlap);
  ASSERT_EQ(answer.pairs.size(), truth.count);
  ASSERT_EQ(answer.hash(), truth.hash);
  ASSERT_EQ(answer.coverage, Coverage::complete);
}

void check_modes(const test::TruthCase& truth, const Body& a, const Body& b,
                 const std::vector<TrianglePair>& all) {
  const Overlap any = overlap(a, b, {.mode = OverlapMode::any});
  ASSERT_EQ(any.any, truth.overlap);
  const Overlap first = overlap(a, b, {.mode = OverlapMode::first});
  const Overlap limited = overlap(a, b, {.limit = 5});
  ASSERT_EQ(limited.pairs.size(), std::min<std::uint64_t>(5, truth.count));
  if (truth.overlap) {
    ASSERT_EQ(first.pairs, std::vector{all.front()});
    ASSERT_TRUE(std::binary_search(all.begin(), all.end(), any.pairs.front()));
  }
  ASSERT_TRUE(std::includes(all.begin(), all.end(), limited.pairs.begin(), limited.pairs.end()));
}

void run(const std::vector<test::TruthCase>& cases) {
  for (std::size_t i = 0; i < cases.size(); i += test::kSlowBuild ? 3 : 1) {
    const test::TruthCase& truth = cases[i];
    SCOPED_TRACE("case " + std::to_string(truth.number) + ", " + truth.kind);
    const Body a(shape_of(truth.mesh_a), truth.pose_a);
    const Body b(shape_of(truth.mesh_b), truth.pose_b);
    const Overlap answer = overlap(a, b);
    ASSERT_NO_FATAL_FAILURE(check_case(truth, answer));
    ASSERT_NO_FATAL_FAILURE(check_modes(truth, a, b, answer.pairs));
    const Overlap threaded = overlap(a, b, {}, {.threads = 2});
    ASSERT_NO_FATAL_FAILURE(check_case(truth, threaded));
    ASSERT_EQ(threaded.cost, answer.cost);
  }
}

TEST(OverlapTruth, HoldsForAllCasesOnOurOwnMeshes) {
  const auto cases = test::truth_cases(test::Models::own);
  ASSERT_EQ(cases.size(), 3780U);
  run(cases);
}

TEST(OverlapTruth, HoldsForAllCasesOnModelsOfOthers) {
  SOMS_NEEDS_OUTSIDE_DATA("840 cases of the truth set");
  const auto cases = test::truth_cases(test::Models::of_others);
  ASSERT_EQ(cases.size(), 840U);
  run(cases);
}

TEST(OverlapTruth, HoldsInBatches) {
  // Cases of the same two meshes with the second at the same place are queried at once.
  std::map<std::string, std::vector<const test::TruthCase*>> groups;
  const auto runnable = test::runnable_truth_cases();
  for (const test::TruthCase& truth : runnable.cases) {
    groups[truth.mesh_a + "/" + truth.mesh_b].push_back(&truth);
  }
  for (const auto& [name, group] : groups) {
    SCOPED_TRACE(name);
    std::size_t begin = 0;
    while (begin < group.size()) {
      std::size_t end = begin;
      std::vector<Pose> poses;
      while (end < group.size() && group[end]->pose_b == group[begin]->pose_b) {
        poses.push_back(group[end]->pose_a);
        ++end;
      }
      const OverlapBatch batch =
          overlap(shape_of(group[begin]->mesh_a), poses,
                  Body(shape_of(group[begin]->mesh_b), group[begin]->pose_b), {}, {.threads = 2});
      for (std::size_t k = 0; k < poses.size(); ++k) {
        const test::TruthCase& truth = *group[begin + k];
        SCOPED_TRACE(truth.number);
        Overlap answer;
        answer.any = batch.any[k] != 0;
        answer.coverage = batch.coverage[k];
        answer.pairs.assign(batch.pairs_of(k).begin(), batch.pairs_of(k).end());
        ASSERT_NO_FATAL_FAILURE(check_case(truth, answer));
      }
      begin = end;
    }
  }
}

}  // namespace
}  // namespace soms
