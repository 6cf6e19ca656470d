// No triangle with a point in a box of the world is lost, wherever its body is.
#include "soms/query/detail/nodes_in_box.h"

#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace soms {
namespace {

/// The triangles of a leaf, or of all leaves below a node.
void collect(const Shape& shape, std::uint32_t id, std::set<TriangleId>& triangles) {
  const detail::WideSource source(shape);
  const WideNode& node = source.node(detail::index_of(id));
  for (std::uint32_t lane = 0; lane < node.count; ++lane) {
    if (detail::is_lane(id) && detail::lane_of(id) != lane) {
      continue;
    }
    if (!detail::is_lane(id) && (node.leaves >> lane & 1U) == 0) {
      collect(shape, detail::child_id(node, id, lane), triangles);
      continue;
    }
    for (std::uint32_t token = node.child[lane];; token = source.next(token)) {
      const TriangleBlock& block = source.block(token);
      triangles.insert(block.id.begin(), block.id.begin() + block.count);
      if (block.following == 0) {
        break;
      }
    }
  }
}

TEST(NodesInBox, HoldEveryTriangleWithAPointInTheBox) {
  std::size_t held = 0;
  std::size_t all = 0;
  test::for_each_case("query/nodes-in-box", 40, [&](Rng& rng) {
    const Mesh mesh = generate_knot(2000 + 2 * rng.below(100));
    Pose pose = rng.below(4) == 0 ? Pose{} : test::awkward_rotation(rng);
    const double far = std::exp2(rng.uniform(-2, 45));
    for (std::size_t k = 0; k < 3; ++k) {
      pose.m[4 * k + 3] = far * rng.uniform(-1, 1);
    }
    const Body body(Shape(mesh), pose);
    const auto moved = reference::detail::moved_triangles(mesh, pose);
    for (int i = 0; i < 20; ++i) {
      const std::size_t k = rng.below(moved.size());
      Box box{moved[k].b, moved[k].b};
      const double more = rng.below(2) == 0 ? 0 : rng.uniform(0, 0.05);
      box.lower = box.lower - Vec3{more, 0, more};
      box.upper.y += more;
      std::vector<std::uint32_t> nodes;
      Cost cost;
      detail::find_nodes(box, body, nodes, cost);
      std::set<TriangleId> triangles;
      for (const std::uint32_t node : nodes) {
        collect(body.shape, node, triangles);
      }
      ASSERT_EQ(triangles.count(static_cast<TriangleId>(k)), 1U);
      held += far < 1 ? triangles.size() : 0;
      all += far < 1 ? moved.size() : 0;
    }
  });
  EXPECT_LT(8 * held, all);  // and most are left out
}

TEST(NodesInBox, AreNoneOfAnEmptyBoxOrAFarOne) {
  const Body body(Shape(generate_knot(2000)));
  std::vector<std::uint32_t> nodes{1};
  Cost cost;
  detail::find_nodes({}, body, nodes, cost);
  EXPECT_TRUE(nodes.empty());
  detail::find_nodes({{1e6, 0, 0}, {1e6, 0, 0}}, body, nodes, cost);
  EXPECT_TRUE(nodes.empty());
}

TEST(NodesInBox, AreTheRootOfACompactBody) {
  const Body body(Shape(generate_knot(2000), {.layout = Layout::compact}));
  std::vector<std::uint32_t> nodes;
  Cost cost;
  detail::find_nodes({{0, 0, 0}, {0, 0, 0}}, body, nodes, cost);
  EXPECT_EQ(nodes, std::vector<std::uint32_t>{detail::kRootId});
}

}  // namespace
}  // namespace soms
