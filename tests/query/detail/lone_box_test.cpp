#include "soms/query/detail/lone_box.h"

#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/reference/overlap.h"
#include "soms/tree/shape.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <cmath>
#include <set>
#include <vector>

namespace soms::detail {
namespace {

/// Small triangles all over a cube, more than a turned node may hold: the upper nodes have the
/// mesh's axes.
Mesh crowd(Rng& rng) {
  Mesh mesh;
  const Box cube{{-1, -1, -1}, {1, 1, 1}};
  for (std::uint32_t i = 0; i < 1500; ++i) {
    const Vec3 at = test::point_in(rng, cube);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(at + 0.02 * test::point_in(rng, cube));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// All triangles below the places of y in `seeds`.
std::set<TriangleId> below(const PairList& seeds, const WideTree& y) {
  std::set<TriangleId> ids;
  std::vector<std::uint32_t> words;
  const auto lane = [&](const WideNode& node, std::size_t k) {
    if ((node.leaves >> k & 1U) == 0) {
      words.push_back(node.child[k]);
      return;
    }
    std::size_t block = node.child[k] & (WideNode::kMost - 1);
    for (bool more = true; more; ++block) {
      const TriangleBlock& b = y.blocks()[block];
      ids.insert(b.id.begin(), b.id.begin() + b.count);
      more = b.following > 0;
    }
  };
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::uint32_t code = seeds.at(i).y;
    EXPECT_EQ(seeds.at(i).x, 0U);
    if ((code & NodeTask::kLane) != 0) {
      lane(y.nodes()[code >> 3], code & 3);
    } else {
      words.push_back(code >> 3);
    }
  }
  while (!words.empty()) {
    const WideNode& node = y.nodes()[words.back()];
    words.pop_back();
    for (std::size_t k = 0; k < node.count; ++k) {
      lane(node, k);
    }
  }
  return ids;
}

// Corner on corner, along an axis of the large body, where boxes only just touch: without a margin
// 2 of 288 such cases lose a triangle.
TEST(LoneBox, LeadsToEveryTriangleThatTheBodyTouches) {
  std::size_t alone = 0;
  std::size_t few = 0;
  test::for_each_case("lone-box/touch", 300, [&](Rng& rng) {
    const double scale = rng.below(2) ? 1 : std::exp2(rng.uniform(-1000, 280));
    const double far = rng.below(2) ? 0 : scale * std::exp2(rng.uniform(-8, 8));
    const Vec3 place{far, -0.5 * far, 0.25 * far};
    const Shape large(test::placed(crowd(rng), scale, rng.below(2) ? place : Vec3{}));
    const Shape small(test::placed(test::awkward_mesh(rng, 10),
                                   scale * std::exp2(-rng.uniform(2, 14)),
                                   rng.below(2) ? place : Vec3{}));
    Pose turn = test::awkward_rotation(rng);
    Pose fixed = rng.below(2) ? Pose{} : test::awkward_rotation(rng);
    fixed.m[7] = far * rng.unit();
    // The corner that is farthest along one of the large body's axes goes to one of its corners.
    const std::size_t axis = rng.below(3);
    const Vec3 n{fixed.m[axis], fixed.m[4 + axis], fixed.m[8 + axis]};
    Vec3 corner = small.mesh().vertices[small.mesh().triangles[0][0]];
    for (const auto& triangle : small.mesh().triangles) {
      for (const std::uint32_t v : triangle) {
        const Vec3& p = small.mesh().vertices[v];
        corner = dot(n, turn.apply(p)) > dot(n, turn.apply(corner)) ? p : corner;
      }
    }
    const auto& vertices = large.mesh().vertices;
    const Pose pose = test::moving(turn, corner, fixed.apply(vertices[rng.below(vertices.size())]));

    const RelativePose relative(small.layout(), pose, Viewer(large.layout(), fixed));
    const Overlap expected = reference::overlap(small.mesh(), pose, large.mesh(), fixed);
    const LoneBox box = relative.lone_box();
    if (relative.apart() || !box.pays(large.layout().nodes()[0])) {
      ASSERT_TRUE(!relative.apart() || !expected.any);
      return;
    }
    ++alone;
    PairList stack;
    PairList seeds;
    Cost cost;
    box.descend(large.layout().nodes().data(), stack, seeds, cost);
    EXPECT_TRUE(stack.empty());
    EXPECT_GT(cost.node_tests, 0U);
    const std::set<TriangleId> found = below(seeds, large.layout());
    for (const auto& [i, j] : expected.pairs) {
      ASSERT_EQ(found.count(j), 1U);
    }
    few += 4 * found.size() < large.mesh().triangles.size() ? 1U : 0U;
  });
  EXPECT_GT(alone, 150U);
  EXPECT_GT(few, 100U);
}

}  // namespace
}  // namespace soms::detail
