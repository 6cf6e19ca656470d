#include "soms/tree/layout/detail/wide_tree.h"

#include "soms/tree/build.h"
#include "soms/tree/rule/rules.h"

#include "tests/support/support.h"
#include "tests/tree/layout/whole.h"

#include <algorithm>
#include <cmath>

namespace soms {
namespace {

/// Triangles of sizes and places that differ by many powers of two.
Mesh scattered(Rng& rng, std::size_t triangles, double scale, double far) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles; ++i) {
    const double size = scale * std::exp2(-rng.uniform(0, 20));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const Vec3 at{rng.uniform(-scale, scale), rng.uniform(-scale, scale), far};
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(at + Vec3{size * rng.unit(), size * rng.unit(), size * rng.unit()});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

using test::expect_whole;

TEST(WideTree, HoldsEveryTriangleOnceAndInsideItsBoxes) {
  test::for_each_case("wide_tree/holds", 120, [](Rng& rng) {
    const double scale = std::exp2(rng.below(2) ? rng.uniform(-1000, 298) : 0);
    const double far = rng.below(2) ? 0 : scale * 1e6;
    const Mesh mesh = scattered(rng, 1 + rng.below(200), scale, std::min(far, 0x1p299));
    BuildOptions options;
    options.per_leaf = static_cast<int>(1 + rng.below(20));
    options.rule = static_cast<Rule>(rng.below(rules().size()));
    const WideTree tree(build(mesh, options), mesh);
    ASSERT_NO_FATAL_FAILURE(expect_whole(tree, mesh));
  });
}

TEST(WideTree, TurnsNodesOfSlantedSurfacesOnlyAndFlatLeavesFillNoSlab) {
  // A patch of 200 triangles in the plane x + y + z = 0, and the same in z = 0.
  const auto patch = [](bool slanted) {
    Mesh mesh;
    Rng rng(9);
    for (int i = 0; i < 200; ++i) {
      const Vec3 at{rng.uniform(-1, 1), rng.uniform(-1, 1), 0};
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const Vec3& off : {Vec3{0, 0, 0}, Vec3{0.05, 0, 0}, Vec3{0, 0.05, 0}}) {
        Vec3 v = at + off;
        v.z = slanted ? -v.x - v.y : 0;
        mesh.vertices.push_back(v);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return WideTree(build(mesh), mesh);
  };
  const WideTree slanted = patch(true);
  const WideTree level = patch(false);
  EXPECT_EQ(slanted.nodes()[0].oriented, 1);
  EXPECT_EQ(level.nodes()[0].oriented, 0);
  for (const WideTree* tree : {&slanted, &level}) {
    for (const TriangleBlock& block : tree->blocks()) {
      EXPECT_LT(block.upper - block.lower, 1e-6F);
    }
  }
}

TEST(WideTree, PassesOverNodesWithoutTriangles) {
  Rng rng(3);
  const Mesh mesh = scattered(rng, 60, 1, 0);
  BuildOptions options = thesis_options(Rule::spatial_median, 30);
  options.empty_side = EmptySide::chain;
  ASSERT_NO_FATAL_FAILURE(expect_whole(WideTree(build(mesh, options), mesh), mesh));
}

TEST(WideTree, HoldsLeavesOfAnySizeAndIdenticalTriangles) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.resize(1000, {0, 1, 2});
  for (const EmptySide side : {EmptySide::stop, EmptySide::object_median}) {
    BuildOptions options = thesis_options(Rule::soms);
    options.empty_side = side;
    ASSERT_NO_FATAL_FAILURE(expect_whole(WideTree(build(mesh, options), mesh), mesh));
  }
}

// Beyond 8192 triangles a tree is laid out in parts.
TEST(WideTree, InPartsIsWholeAndTheSameForAnyNumberOfThreads) {
  Rng rng(17);
  const Mesh mesh = scattered(rng, 30'000, 1, 0);
  for (const EmptySide side : {EmptySide::object_median, EmptySide::stop, EmptySide::chain}) {
    BuildOptions options;
    options.empty_side = side;
    options.level = side == EmptySide::chain ? 30 : 0;
    options.rule = side == EmptySide::chain ? Rule::spatial_median : Rule::sah;
    const Tree tree = build(mesh, options);
    const WideTree one(tree, mesh);
    ASSERT_NO_FATAL_FAILURE(expect_whole(one, mesh));
    for (const int threads : {2, 3, 8}) {
      EXPECT_EQ(WideTree(tree, mesh, Limits{.threads = threads}), one) << threads;
    }
  }
}

// Twins cannot be divided: one node above the parts keeps more triangles than a part may have.
TEST(WideTree, HoldsALeafLargerThanAPart) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 0, 0}, {9, 0, 0}, {8, 1, 0}};
  mesh.triangles.resize(20'000, {0, 1, 2});
  mesh.triangles.resize(30'000, {3, 4, 5});
  BuildOptions options = thesis_options(Rule::soms);
  ASSERT_NO_FATAL_FAILURE(expect_whole(WideTree(build(mesh, options), mesh), mesh));
}

TEST(WideTree, OfNothingHasNoNode) {
  const WideTree tree(build({}), {});
  EXPECT_TRUE(tree.nodes().empty());
  EXPECT_TRUE(tree.blocks().empty());
  EXPECT_TRUE(tree.bounds().empty());
}

TEST(WideTree, ScalesOnlyBodiesOfUnusualSize) {
  Rng rng(5);
  const auto exponent = [&](double scale) {
    const Mesh mesh = scattered(rng, 5, scale, 0);
    return WideTree(build(mesh), mesh).exponent();
  };
  EXPECT_EQ(exponent(1), 0);
  EXPECT_EQ(exponent(1e5), 0);
  EXPECT_EQ(exponent(1e-5), 0);
  EXPECT_GT(exponent(1e-30), 80);
  EXPECT_LT(exponent(1e30), -80);
}

}  // namespace
}  // namespace soms
