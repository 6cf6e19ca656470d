// The truth set by every traversal and every rule: 4,620 posed pairs of meshes whose overlaps were
// decided by two independent exact methods.
#include "tests/support/truth/truth.h"

#include "soms/thesis/named_overlap.h"
#include "soms/thesis/traversals.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// Shapes of the set's meshes, built once for each test.
class Shapes {
 public:
  explicit Shapes(const BuildOptions& options) : options_(options) {}

  const Shape& operator[](const std::string& name) {
    const auto known = shapes_.find(name);
    if (known != shapes_.end()) {
      return known->second;
    }
    const ShapeOptions options{.build = options_, .keep_tree = true};
    return shapes_.emplace(name, Shape(*test::truth_mesh(name), options)).first->second;
  }

 private:
  BuildOptions options_;
  std::map<std::string, Shape> shapes_;
};

void expect_truth(const Overlap& answer, const test::TruthCase& c) {
  EXPECT_EQ(answer.any, c.overlap) << "case " << c.number;
  EXPECT_EQ(answer.pairs.size(), c.count) << "case " << c.number;
  EXPECT_EQ(answer.hash(), c.hash) << "case " << c.number;
  EXPECT_EQ(answer.coverage, Coverage::complete) << "case " << c.number;
}

/// All cases; in slow builds each sixteenth, of which `offset` says the first.
std::vector<test::TruthCase> chosen(const test::RunnableCases& runnable, std::size_t offset) {
  std::vector<test::TruthCase> out;
  const std::size_t step = test::kSlowBuild ? 16 : 1;
  for (std::size_t i = offset % step; i < runnable.cases.size(); i += step) {
    out.push_back(runnable.cases[i]);
  }
  return out;
}

/// All cases by one traversal. Poses of a pair of meshes go to one session, so a front goes
/// from pose to pose, also where they have nothing to do with each other.
void expect_all(const BuildOptions& build, const TraversalOptions& traversal) {
  const test::RunnableCases runnable = test::runnable_truth_cases();
  Shapes shapes(build);
  std::optional<thesis::NamedOverlap> session;
  std::pair<std::string, std::string> meshes;
  for (const test::TruthCase& c : chosen(runnable, static_cast<std::size_t>(traversal.traversal))) {
    if (!session || meshes != std::pair(c.mesh_a, c.mesh_b)) {
      meshes = {c.mesh_a, c.mesh_b};
      session.emplace(shapes[c.mesh_a], shapes[c.mesh_b], traversal);
    }
    expect_truth((*session)(c.pose_a, c.pose_b, {}, {}), c);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  if (runnable.skipped > 0) {
    GTEST_SKIP() << "SOMS_DATA is unset: " << runnable.cases.size() << " cases are right, skipped "
                 << runnable.skipped;
  }
}

std::vector<TraversalOptions> ways_of_truth() {
  std::vector<TraversalOptions> out;
  for (const TraversalOptions& options : test::every_traversal_options()) {
    // Without pruning each way would take minutes; recursion and order are tried once, below.
    const bool twice = options.traversal == Traversal::ericson;
    if (options.prune && !options.recursive && !twice && options.order == EntryOrder::tree) {
      out.push_back(options);
    }
  }
  out.push_back({.traversal = Traversal::ericson, .recursive = true});
  out.push_back({.traversal = Traversal::e_node, .order = EntryOrder::volume});
  out.push_back({.traversal = Traversal::larger, .update = BoxUpdate::rebox});
  return out;
}

/// `text` with underscores where a test's name may not have its characters.
std::string test_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '='; }, '_');
  return text;
}

class TruthByTraversal : public testing::TestWithParam<TraversalOptions> {};

TEST_P(TruthByTraversal, HoldsInEveryCase) {
  expect_all(thesis_options(Rule::soms, 24), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Traversal, TruthByTraversal, testing::ValuesIn(ways_of_truth()),
                         [](const auto& test) { return test_name(test::describe(test.param)); });

class TruthByRule : public testing::TestWithParam<RuleEntry> {};

TEST_P(TruthByRule, HoldsInTheThesisTreeByENode) {
  expect_all(thesis_options(GetParam().rule), {.traversal = Traversal::e_node});
}

TEST_P(TruthByRule, HoldsInTheProductsTreeByTheDefaultTraversal) {
  const test::RunnableCases runnable = test::runnable_truth_cases();
  Shapes shapes({.rule = GetParam().rule});
  for (const test::TruthCase& c : chosen(runnable, static_cast<std::size_t>(GetParam().rule))) {
    expect_truth(overlap(Body(shapes[c.mesh_a], c.pose_a), Body(shapes[c.mesh_b], c.pose_b)), c);
    ASSERT_FALSE(HasFailure());
  }
  if (runnable.skipped > 0) {
    GTEST_SKIP() << "SOMS_DATA is unset: " << runnable.cases.size() << " cases are right, skipped "
                 << runnable.skipped;
  }
}

INSTANTIATE_TEST_SUITE_P(Traversal, TruthByRule, testing::ValuesIn(rules().begin(), rules().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace soms
