#include "soms/tree/build/detail/morton.h"

#include "soms/tree/build.h"
#include "soms/tree/check.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include "tests/support/support.h"
#include "tests/tree/inputs.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace soms {
namespace {

using detail::MortonCodes;
using detail::MortonKey;

void add_flat(Mesh& mesh, double x, double y, double size) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{x, y, 0}, {x + size, y, 0}, {x, y + size, 0}});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Small triangles on a square of side 64.
Mesh small_ones() {
  Mesh mesh;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      add_flat(mesh, x, y, 0.5);
    }
  }
  return mesh;
}

TEST(Morton, SortsKeysByTheirCodesForAnyNumberOfThreads) {
  Rng rng(1);
  for (const std::size_t count : {std::size_t{1}, std::size_t{2}, std::size_t{1000}}) {
    for (const int bits : {0, 1, 11, 12, 40}) {
      layout::Pages<MortonKey> keys;
      keys.resize(count);
      for (MortonKey& key : keys) {
        key = MortonKey{rng.below(1U << 31)} << 33 ^ rng.below(1U << 31);
      }
      std::vector<MortonKey> expected(keys.begin(), keys.end());
      std::stable_sort(expected.begin(), expected.end(), [bits](MortonKey a, MortonKey b) {
        return bits > 0 && a >> (64 - bits) < b >> (64 - bits);
      });
      for (const int threads : {1, 3}) {
        layout::Pages<MortonKey> sorted = keys;
        layout::Pages<MortonKey> spare;
        spare.resize(count);
        detail::radix_sort(sorted, spare, 64 - bits, 64, Limits{.threads = threads});
        EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin())) << bits;
      }
    }
  }
}

TEST(Morton, KeysHoldEachTriangleOnce) {
  for (const test::Input input : test::kInputs) {
    SCOPED_TRACE(test::name(input));
    const Mesh mesh = test::make_input(input, 3000);
    const auto keys = detail::sorted_keys(mesh, bounds(mesh), {});
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    const MortonKey ids = (MortonKey{1} << detail::id_bits_for(3000)) - 1;
    std::set<MortonKey> seen;
    for (const MortonKey key : keys) {
      seen.insert(key & ids);
    }
    EXPECT_EQ(seen.size(), 3000U);
    EXPECT_EQ(*seen.rbegin(), 2999U);
  }
}

// The first bit of a code is whether a triangle is small against all; the next, on which half of
// the longest side its middle is.
TEST(Morton, CodesDivideBySizeThenByTheLongestSide) {
  Mesh mesh = small_ones();
  const auto large = static_cast<TriangleId>(mesh.triangles.size());
  add_flat(mesh, 0, 0, 200);
  const MortonCodes codes(bounds(mesh), mesh.triangles.size(), 13);
  const auto bit = [&](TriangleId id, int place) { return codes.key(mesh, id) >> place & 1; };
  EXPECT_EQ(bit(large, 63), 0U);
  EXPECT_EQ(bit(0, 63), 1U);
  EXPECT_EQ(bit(large, 62), 1U);  // its middle lies on the plane
  EXPECT_EQ(bit(63, 62), 0U);
}

TEST(Morton, CodesHalveALongStripAcrossItsLength) {
  Mesh mesh;
  for (int k = 0; k < 16; ++k) {
    add_flat(mesh, k, k % 2, 0.5);
  }
  const MortonCodes codes(bounds(mesh), mesh.triangles.size(), 4);
  for (TriangleId id = 0; id < 16; ++id) {
    EXPECT_EQ(codes.key(mesh, id) >> 61, id / 2) << id;
  }
}

TEST(Morton, RefinesRunsOfOneCodeUnlessTheirMiddlesAreOne) {
  Mesh mesh;
  for (int k = 0; k < 9; ++k) {
    add_flat(mesh, 1 + (k % 3 == 0 ? 0x1p-40 : 0), 1, 0.5);
  }
  add_flat(mesh, 1e6, 1e6, 1);
  auto keys = detail::sorted_keys(mesh, bounds(mesh), {});
  const int id_bits = detail::id_bits_for(10);
  const auto run = std::span(keys).first(9);
  ASSERT_EQ((run.front() ^ run.back()) >> id_bits, 0U);
  EXPECT_TRUE(detail::refine_keys(mesh, run, id_bits));
  std::vector<TriangleId> order;
  for (const MortonKey key : run) {
    order.push_back(static_cast<TriangleId>(key & 15));
  }
  EXPECT_EQ(order, (std::vector<TriangleId>{1, 2, 4, 5, 7, 8, 0, 3, 6}));
  EXPECT_FALSE(detail::refine_keys(mesh, run.first(6), id_bits));
}

TEST(BuildQuick, SetsLargeTrianglesApartFirst) {
  Mesh mesh = small_ones();
  std::vector<TriangleId> large;
  for (const double at : {0.0, 5.0, 11.0}) {
    large.push_back(static_cast<TriangleId>(mesh.triangles.size()));
    add_flat(mesh, at, at, 40);
  }
  const Tree tree = build(mesh, {.rule = Rule::quick});
  ASSERT_EQ(find_fault(tree, mesh), "");
  const auto apart = tree.triangles_of(tree.nodes[tree.nodes[0].left]);
  EXPECT_EQ(std::vector<TriangleId>(apart.begin(), apart.end()), large);
}

// Unless middles are one, or depths near the last, so that nodes are halved.
TEST(BuildQuick, MakesNoMoreLeavesThanItMustOfFew) {
  for (const int per_leaf : {1, 2, 3, 8}) {
    const BuildOptions options{.rule = Rule::quick, .per_leaf = per_leaf};
    const auto most = static_cast<std::uint32_t>(per_leaf);
    for (const test::Input input : test::kInputs) {
      SCOPED_TRACE(test::name(input) + " " + std::to_string(per_leaf));
      const Mesh mesh = test::make_input(input, 500);
      const Tree tree = build(mesh, options);
      ASSERT_EQ(find_fault(tree, mesh), "");
      std::vector<std::uint32_t> leaves(tree.nodes.size(), 1);
      std::vector<bool> halved(tree.nodes.size());
      for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        const Node& node = tree.nodes[i];
        halved[i] = node.undividable || node.depth + 8 > kMaxTreeIdDepth;
        if (node.is_leaf()) {
          continue;
        }
        leaves[i] = leaves[node.left] + leaves[node.right];
        halved[i] = halved[i] || halved[node.left] || halved[node.right];
        if (!halved[i] && node.count <= 4 * most) {
          EXPECT_EQ(leaves[i], (node.count + most - 1) / most) << node.count;
        }
      }
    }
  }
}

// A cut at the highest bit may leave one triangle, and codes may be refined again and again.
TEST(BuildQuick, EndsAboveDepth64WhereverTrianglesLie) {
  for (const test::Input input : test::kInputs) {
    for (const std::size_t size : {std::size_t{3}, std::size_t{1000}, std::size_t{20000}}) {
      SCOPED_TRACE(test::name(input) + " " + std::to_string(size));
      const Mesh mesh = test::make_input(input, size);
      for (const int per_leaf : {1, 8}) {
        const Tree tree = build(mesh, {.rule = Rule::quick, .per_leaf = per_leaf});
        ASSERT_EQ(find_fault(tree, mesh), "");
        for (const Node& node : tree.nodes) {
          ASSERT_LE(node.depth, 63U);
          ASSERT_NE(node.id, kNoTreeId);
          ASSERT_TRUE(!node.is_leaf() || node.count <= static_cast<std::uint32_t>(per_leaf));
        }
      }
    }
  }
}

// One far triangle leaves a single code for all the others.
TEST(BuildQuick, DividesWhatLiesInOneCellOfAll) {
  Mesh mesh = small_ones();
  add_flat(mesh, 1e9, 1e9, 1);
  const BuildOptions options{.rule = Rule::quick};
  const Tree tree = build(mesh, options);
  ASSERT_EQ(find_fault(tree, mesh), "");
  std::size_t leaves = 0;
  for (const Node& node : tree.nodes) {
    leaves += node.is_leaf() ? 1U : 0U;
    EXPECT_FALSE(node.undividable);
    if (node.is_leaf() && node.count > 1) {
      const Vec3 extent = node.bounds.extent();
      EXPECT_LE(std::max(extent.x, extent.y), 8);
    }
  }
  EXPECT_LE(leaves, mesh.triangles.size() / 4);
  EXPECT_TRUE(build_wide(mesh, options, Limits{.threads = 3}) == WideTree(tree, mesh));
}

TEST(BuildQuick, OfUnusedVerticesFarAwayIsTheSame) {
  Mesh mesh = small_ones();
  const Tree before = build(mesh, {.rule = Rule::quick});
  mesh.vertices.push_back({1e100, -1e100, 0});
  EXPECT_TRUE(build(mesh, {.rule = Rule::quick}) == before);
}

}  // namespace
}  // namespace soms
