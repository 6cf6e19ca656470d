#include "soms/tree/layout/detail/start_nodes.h"

#include "soms/base/box.h"
#include "soms/tree/layout/detail/wide_tree.h"
#include "soms/tree/shape.h"

#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace soms::layout {
namespace {

/// Small triangles on hills, and a few wide ones.
Mesh hills(Rng& rng, std::size_t triangles, std::size_t flat) {
  Mesh mesh;
  const std::size_t a = (flat + 1) % 3;
  const std::size_t b = (flat + 2) % 3;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const double size = rng.below(50) == 0 ? 0.5 : 0.02;
    const double x = rng.uniform(-1, 1);
    const double y = rng.uniform(-1, 1);
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 v;
      v[a] = x + size * rng.uniform(-1, 1);
      v[b] = y + size * rng.uniform(-1, 1);
      v[flat] = 0.1 * std::sin(3 * v[a]) * std::cos(2 * v[b]) + 0.01 * rng.unit();
      mesh.vertices.push_back(v);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// All triangles below some nodes.
std::set<TriangleId> below(std::span<const std::uint32_t> starts, const WideTree& tree) {
  std::set<TriangleId> ids;
  std::vector<std::uint32_t> open(starts.begin(), starts.end());
  while (!open.empty()) {
    const WideNode& node = tree.nodes()[open.back()];
    open.pop_back();
    for (std::size_t k = 0; k < node.count; ++k) {
      if ((node.leaves >> k & 1U) == 0) {
        open.push_back(node.child[k]);
        continue;
      }
      std::size_t block = node.child[k] & (WideNode::kMost - 1);
      for (bool more = true; more; ++block) {
        const TriangleBlock& b = tree.blocks()[block];
        ids.insert(b.id.begin(), b.id.begin() + b.count);
        more = b.following > 0;
      }
    }
  }
  return ids;
}

// The twin looks at the columns of every corner. They are found as those of the box are.
TEST(StartNodes, HaveEveryTriangleOfTheBoxBelowThem) {
  std::size_t found = 0;
  std::size_t few = 0;
  std::size_t boxes = 0;
  test::for_each_case("start-nodes", 60, [&](Rng& rng) {
    const std::size_t flat = rng.below(3);
    Mesh made = hills(rng, 1 + rng.below(3000), flat);
    const double far = rng.below(3) == 0 ? std::exp2(rng.uniform(10, 40)) : 0;
    for (Vec3& v : made.vertices) {
      v = v + Vec3{far, -far, far};
    }
    const Shape shape(made);
    const WideTree& tree = shape.layout();
    if (tree.min_max_grid().empty()) {
      return;
    }
    const GroundPlan& plan = tree.min_max_grid().plan();
    const auto& vertices = shape.mesh().vertices;
    for (int i = 0; i < 100; ++i) {
      const Vec3 at = vertices[rng.below(vertices.size())] - tree.origin();
      const double half = 0.5 * std::exp2(-rng.uniform(0, 14)) * tree.scale();
      std::array<double, 3> center;
      for (std::size_t k = 0; k < 3; ++k) {
        center[k] = at[k] * tree.scale() + rng.uniform(-1, 1) * half;
      }
      PlanBox box;
      plan.place(center, {half, half, half}, box);
      const auto starts = tree.start_nodes().of(box);
      ASSERT_LE(starts.size(), 16U);
      const std::set<TriangleId> ids = below(starts, tree);
      for (TriangleId id = 0; id < shape.mesh().triangles.size(); ++id) {
        bool inside = false;
        for (const std::uint32_t v : shape.mesh().triangles[id]) {
          bool in = true;
          for (std::size_t k = 0; k < 2; ++k) {
            const double x = (vertices[v] - tree.origin())[plan.axis[k]] * tree.scale();
            const std::uint32_t column = plan.column(k, x);
            in = in && column >= box.from[k] && column <= box.to[k];
          }
          inside = inside || in;
        }
        ASSERT_TRUE(!inside || ids.count(id) == 1) << id;
        found += inside ? 1U : 0U;
      }
      few += 4 * ids.size() < shape.mesh().triangles.size() ? 1U : 0U;
      ++boxes;
    }
  });
  EXPECT_GT(found, 5000U);
  EXPECT_GT(4 * few, boxes);
}

TEST(StartNodes, AreMadeForFlatMeshesOnly) {
  Rng rng(1);
  EXPECT_GT(Shape(hills(rng, 3000, 2)).layout().start_nodes().memory(), 0U);
  Mesh steep = hills(rng, 3000, 2);
  for (Vec3& v : steep.vertices) {
    v.z *= 10;
  }
  EXPECT_EQ(Shape(steep).layout().start_nodes().memory(), 0U);
}

TEST(StartNodes, TakeTwoBytesATriangle) {
  Rng rng(2);
  const Shape shape(hills(rng, 40'000, 2));
  EXPECT_LT(shape.layout().start_nodes().memory(), 2 * shape.mesh().triangles.size());
}

// Every cell has all nodes above it, so each would look at all of them.
TEST(StartNodes, BeginAtTheRootWhereEveryTriangleIsAsWideAsTheMesh) {
  Mesh plates;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const double z = 0.1 * i / 20'000;
    plates.vertices.insert(plates.vertices.end(), {{-1, -1, z}, {1, -1, z}, {0, 1, z}});
    plates.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Shape shape(plates);
  const WideTree& tree = shape.layout();
  ASSERT_FALSE(tree.min_max_grid().empty());
  PlanBox box;
  tree.min_max_grid().plan().place({0.3, -0.4, 0}, {0.001, 0.001, 0.001}, box);
  const auto starts = tree.start_nodes().of(box);
  EXPECT_EQ(std::vector(starts.begin(), starts.end()), std::vector<std::uint32_t>{0});
}

TEST(StartNodes, AreTheSameAfterRefittingNothing) {
  Rng rng(3);
  const Shape shape(hills(rng, 5000, 2));
  const WideTree again(shape.layout(), shape.mesh());
  EXPECT_EQ(again.start_nodes(), shape.layout().start_nodes());
}

}  // namespace
}  // namespace soms::layout
