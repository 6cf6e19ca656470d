#include "soms/tree/statistics.h"

#include "soms/tree/build.h"

#include "tests/tree/inputs.h"

namespace soms {
namespace {

/// Triangles at x = 0, 1, 2, ..., each of size 0.5.
Mesh row_of(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
    const double x = i;
    mesh.vertices.insert(mesh.vertices.end(), {{x, 0, 0}, {x + 0.5, 0, 0}, {x, 0.5, 0}});
    mesh.triangles.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

TEST(Statistics, CountsAPerfectTreeOfEight) {
  const BuildOptions options = thesis_options(Rule::object_median);
  const TreeStatistics s = statistics(build(row_of(8), options), options);
  TreeStatistics expected;
  expected.nodes = 15;
  expected.leaves = expected.one = expected.lt5 = 8;
  expected.depth = expected.min_leaf_depth = expected.max_leaf_depth = 3;
  expected.largest_leaf = 1;
  expected.balanced_level = 4;
  EXPECT_EQ(s, expected);
}

TEST(Statistics, CountsLeavesOfTheLastLevelAsCapped) {
  const BuildOptions options = thesis_options(Rule::object_median, 3);
  const TreeStatistics s = statistics(build(row_of(21), options), options);
  EXPECT_EQ(s.nodes, 7U);
  EXPECT_EQ(s.capped, 4U);
  EXPECT_EQ(s.lt5, 0U);
  EXPECT_EQ(s.largest_leaf, 6U);
  EXPECT_EQ(s.balanced_level, 3U);
  BuildOptions large = options;
  large.per_leaf = 5;
  EXPECT_EQ(statistics(build(row_of(21), large), large).capped, 1U);  // 5, 5, 5 and 6
}

TEST(Statistics, CountsUndividableAndEmptyNodes) {
  BuildOptions options = thesis_options(Rule::soms, 5);
  const Mesh mesh = test::make_input(test::Input::coincident, 6);
  const TreeStatistics stop = statistics(build(mesh, options), options);
  EXPECT_EQ(stop.nodes, 1U);
  EXPECT_EQ(stop.undividable, 1U);
  EXPECT_EQ(stop.largest_leaf, 6U);
  EXPECT_EQ(stop.balanced_level, 1U);
  options.empty_side = EmptySide::chain;
  const TreeStatistics chain = statistics(build(mesh, options), options);
  EXPECT_EQ(chain.nodes, 9U);
  EXPECT_EQ(chain.empty, 4U);
  EXPECT_EQ(chain.undividable, 4U);
  EXPECT_EQ(chain.leaves, 1U);
  EXPECT_EQ(chain.capped, 1U);
  EXPECT_EQ(chain.depth, 4U);
  EXPECT_EQ(chain.balanced_level, 1U);
  options.empty_side = EmptySide::object_median;
  const TreeStatistics halved = statistics(build(mesh, options), options);
  EXPECT_EQ(halved.undividable, 5U);
  EXPECT_EQ(halved.one, 6U);
}

TEST(Statistics, RootLevelZeroShiftsTheLevelByOne) {
  for (int level = 1; level < 9; ++level) {
    BuildOptions from_one = thesis_options(Rule::spatial_median, level + 1);
    BuildOptions from_zero = thesis_options(Rule::spatial_median, level);
    from_zero.root_level = 0;
    const Mesh mesh = test::make_input(test::Input::random, 300);
    EXPECT_TRUE(build(mesh, from_zero) == build(mesh, from_one));
    EXPECT_EQ(statistics(build(mesh, from_zero), from_zero),
              statistics(build(mesh, from_one), from_one));
  }
}

TEST(Statistics, OfTheEmptyTreeAreZero) {
  EXPECT_EQ(statistics(Tree{}, BuildOptions{}), TreeStatistics{});
  EXPECT_EQ(sah_cost(Tree{}), 0);
}

TEST(SahCost, WeighsNodesByTheirArea) {
  BuildOptions options = thesis_options(Rule::object_median);
  EXPECT_EQ(sah_cost(build(row_of(1), options)), 1);
  EXPECT_EQ(sah_cost(build(row_of(1), options), 2.5), 2.5);
  // Half areas (flat boxes): root 1.5 * 0.5, leaves 0.5 * 0.5 each.
  EXPECT_DOUBLE_EQ(sah_cost(build(row_of(2), options)), 1 + 2.0 / 3);
  EXPECT_DOUBLE_EQ(sah_cost(build(row_of(2), options), 3), 1 + 2.0);
}

TEST(SahCost, IsZeroForATreeWithoutArea) {
  EXPECT_EQ(sah_cost(build(test::make_input(test::Input::points, 1))), 0);
}

}  // namespace
}  // namespace soms
