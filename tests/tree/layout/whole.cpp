#include "tests/tree/layout/whole.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace soms::test {

namespace {

using Point = std::array<long double, 3>;

/// Coordinates a with Q a = v - origin, in units of the layout; long double has 11 bits to spare.
/// The inverse of Q by cross products: whatever Q is, no rounding hides behind "orthonormal".
Point local(const WideTree& tree, const Vec3& v, const std::array<double, 3>& origin,
            const layout::Axes& q) {
  Point x = {};
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] =
        std::ldexp(static_cast<long double>(v[i]) - tree.origin()[i] - origin[i], tree.exponent());
  }
  const auto entry = [&](std::size_t i, std::size_t j) {
    return static_cast<long double>(q[3 * (i % 3) + j % 3]);
  };
  Point a = {};
  long double det = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    det += entry(i, 0) * (entry(i + 1, 1) * entry(i + 2, 2) - entry(i + 1, 2) * entry(i + 2, 1));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      const long double cofactor =
          entry(i + 1, j + 1) * entry(i + 2, j + 2) - entry(i + 1, j + 2) * entry(i + 2, j + 1);
      a[j] += cofactor * x[i] / det;
    }
  }
  return a;
}

void expect_inside(const WideTree& tree, const WideNode& node, std::size_t lane, const Vec3& v) {
  const Point a = local(tree, v, node.origin, node.axes());
  long double distance = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_LE(std::abs(a[axis] - node.center[axis][lane]), node.half[axis][lane]);
    ASSERT_LE(std::abs(a[axis]), node.own_half()[axis]);
    distance += std::abs(a[axis]);
  }
  ASSERT_LE(distance, node.l1_radius);
}

void expect_block_holds(const WideTree& tree, const MeshView& mesh, const TriangleBlock& block) {
  ASSERT_GE(block.count, 1U);
  ASSERT_LE(block.count, TriangleBlock::kWidth);
  long double square = 0;
  for (const float entry : block.normal) {
    square += static_cast<long double>(entry) * entry;
  }
  ASSERT_NEAR(static_cast<double>(std::sqrt(square)), 1, 0x1p-22);
  for (std::size_t k = 0; k < block.count; ++k) {
    const Triangle t = mesh.triangle(block.id[k]);
    std::size_t row = 0;
    for (const Vec3* corner : {&t.a, &t.b, &t.c}) {
      const Point a = local(tree, *corner, block.origin, layout::kMeshAxes);
      long double distance = 0;
      long double along = 0;
      for (std::size_t axis = 0; axis < 3; ++axis, ++row) {
        ASSERT_LE(std::abs(a[axis]), block.own_half[axis]);
        ASSERT_LE(std::abs(a[axis] - block.corner[row][k]), 0x1p-22L * block.l1_radius);
        distance += std::abs(a[axis]);
        along += a[axis] * block.normal[axis];
      }
      ASSERT_LE(distance, block.l1_radius);
      ASSERT_LE(block.lower, along);
      ASSERT_LE(along, block.upper);
    }
  }
}

}  // namespace

void expect_whole(const WideTree& tree, const MeshView& mesh) {
  struct Pending {
    std::uint32_t node;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> above;  // node, lane
  };

  ASSERT_EQ(tree.least_ids().size(), tree.nodes().size());
  std::vector<TriangleId> least(tree.nodes().size(), std::numeric_limits<TriangleId>::max());
  std::vector<int> seen(mesh.triangles.size(), 0);
  std::size_t nodes = 0;
  std::vector<Pending> pending{{0, {}}};
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    ++nodes;
    const WideNode& node = tree.nodes()[next.node];
    ASSERT_GE(node.count, 1U);
    ASSERT_LE(node.count, WideNode::kWidth);
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      auto above = next.above;
      above.emplace_back(next.node, lane);
      const std::uint32_t child = node.child[lane];
      if ((child & WideNode::kLeafBit) == 0) {
        ASSERT_EQ(node.leaves & 1U << lane, 0U);
        pending.push_back({child, above});
        continue;
      }
      const TriangleBlock* block =
          &tree.blocks()[child & ~(WideNode::kLeafBit | WideNode::kRunBit)];
      ASSERT_EQ((child & WideNode::kRunBit) != 0, block->following > 0);
      ASSERT_NE(node.leaves & 1U << lane, 0U);
      for (std::uint32_t left = block->following + 1; left > 0; --left, ++block) {
        ASSERT_EQ(block->following, left - 1);
        ASSERT_NO_FATAL_FAILURE(expect_block_holds(tree, mesh, *block));
        for (std::size_t k = 0; k < block->count; ++k) {
          ++seen[block->id[k]];
          const Triangle t = mesh.triangle(block->id[k]);
          for (const auto& [index, place] : above) {
            least[index] = std::min(least[index], block->id[k]);
            for (const Vec3* corner : {&t.a, &t.b, &t.c}) {
              ASSERT_NO_FATAL_FAILURE(expect_inside(tree, tree.nodes()[index], place, *corner));
            }
          }
        }
      }
    }
  }
  ASSERT_EQ(nodes, tree.nodes().size());
  ASSERT_TRUE(std::equal(least.begin(), least.end(), tree.least_ids().begin()));
  ASSERT_TRUE(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
}

}  // namespace soms::test
