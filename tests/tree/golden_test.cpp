// Every row of thesis_counts.csv. The rows were written by an independent implementation.
#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/option_names.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/statistics.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"
#include "tests/tree/models.h"

#include <map>
#include <string>
#include <vector>

namespace soms {
namespace {

constexpr int kDeepest = 16;
constexpr std::size_t kCounts = 12;

struct Row {
  int level;
  std::array<std::uint64_t, kCounts> counts;
};

/// Rows of one tree at its levels, by "rule,midpoint,axis_from,empty_side".
using Rows = std::map<std::array<std::string, 4>, std::vector<Row>>;

Rows rows_of(const std::string& model) {
  Rows rows;
  for (const auto& line : test::read_csv(test::data("thesis/thesis_counts.csv"))) {
    if (line.at(0) != model) {
      continue;
    }
    Row row{std::stoi(line.at(6)), {}};
    for (std::size_t i = 0; i < kCounts; ++i) {
      row.counts[i] = std::stoull(line.at(7 + i));
    }
    rows[{line[2], line[3], line[4], line[5]}].push_back(row);
  }
  return rows;
}

std::array<std::uint64_t, kCounts> counts_of(const TreeStatistics& s) {
  return {s.nodes,          s.leaves,         s.one,          s.lt5,
          s.undividable,    s.capped,         s.empty,        s.depth,
          s.min_leaf_depth, s.max_leaf_depth, s.largest_leaf, s.balanced_level};
}

BuildOptions options_of(const std::array<std::string, 4>& key, int level) {
  BuildOptions options = thesis_options(rule_named(key[0]).rule, level);
  options.midpoint = midpoint_named(key[1]);
  options.axis_from = axis_from_named(key[2]);
  options.empty_side = empty_side_named(key[3]);
  return options;
}

/// The nodes of levels up to `level`; those of the last one are leaves.
Tree cut(const Tree& tree, int level) {
  Tree result;
  const auto last = static_cast<std::uint32_t>(level - 1);
  for (Node node : tree.nodes) {
    if (node.depth > last) {
      continue;
    }
    if (node.depth == last) {
      node.left = node.right = Node::kNone;
      node.undividable = false;
    }
    result.nodes.push_back(node);
  }
  return result;
}

class Golden : public testing::TestWithParam<test::GoldenModel> {};

TEST_P(Golden, ModelIsTheOneThatWasCounted) {
  const auto mesh = test::golden_mesh(GetParam());
  if (!mesh) {
    GTEST_SKIP() << "SOMS_DATA is unset: skipped the hash of " << GetParam().name;
  }
  EXPECT_EQ(corner_hash(*mesh), GetParam().corners);
}

TEST_P(Golden, EveryRowIsReproduced) {
  const Rows rows = rows_of(GetParam().name);
  ASSERT_EQ(rows.size(), 78U);
  const auto mesh = test::golden_mesh(GetParam());
  if (!mesh) {
    GTEST_SKIP() << "SOMS_DATA is unset: skipped " << rows.size() * kDeepest << " rows of "
                 << GetParam().name;
  }
  constexpr std::size_t kShare = test::kSlowBuild ? 6 : 1;
  std::size_t checked = 0;
  std::size_t number = 0;
  for (const auto& [key, levels] : rows) {
    if (number++ % kShare != 0) {
      continue;
    }
    SCOPED_TRACE(key[0] + " " + key[1] + " " + key[2] + " " + key[3]);
    const Tree deepest = build(*mesh, options_of(key, kDeepest));
    EXPECT_EQ(find_fault(deepest, *mesh), "");
    for (const Row& row : levels) {
      SCOPED_TRACE("level " + std::to_string(row.level));
      const BuildOptions options = options_of(key, row.level);
      ASSERT_EQ(counts_of(statistics(cut(deepest, row.level), options)), row.counts);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 1248U / kShare);
}

// The rows above come from one deep tree each, cut; this builds each level by itself.
TEST_P(Golden, TreeOfALevelIsTheDeepestTreeCut) {
  SOMS_SKIP_IN_SLOW_BUILDS();
  const auto mesh = test::golden_mesh(GetParam());
  if (!mesh) {
    GTEST_SKIP() << "SOMS_DATA is unset: skipped the levels of " << GetParam().name;
  }
  for (const auto& [key, levels] : rows_of(GetParam().name)) {
    if (key[1] != "thesis") {
      continue;
    }
    SCOPED_TRACE(key[0] + " " + key[2] + " " + key[3]);
    for (const Row& row : levels) {
      const BuildOptions options = options_of(key, row.level);
      const Tree tree = build(*mesh, options);
      ASSERT_EQ(counts_of(statistics(tree, options)), row.counts) << "level " << row.level;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Golden, testing::ValuesIn(test::kGoldenModels),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace soms
