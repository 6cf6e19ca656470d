#include "soms/query/detail/single_box_descent.h"

#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/reference/overlap.h"
#include "soms/tree/shape.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace soms::detail {
namespace {

/// Small triangles all over a cube, more than an oriented node may hold: the upper nodes have the
/// mesh's axes.
Mesh many_triangles(Rng& rng) {
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

/// All triangles below the nodes and leaves of y in `seeds`.
std::set<TriangleId> below(const PairList& seeds, const WideTree& y) {
  std::set<TriangleId> ids;
  std::vector<std::uint32_t> tokens;
  const auto lane = [&](const WideNode& node, std::size_t k) {
    if ((node.leaves >> k & 1U) == 0) {
      tokens.push_back(node.child[k]);
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
    const std::uint32_t node_id = seeds.at(i).y;
    EXPECT_EQ(seeds.at(i).x, 0U);
    if ((node_id & NodeTask::kLane) != 0) {
      lane(y.nodes()[node_id >> 3], node_id & 3);
    } else {
      tokens.push_back(node_id >> 3);
    }
  }
  while (!tokens.empty()) {
    const WideNode& node = y.nodes()[tokens.back()];
    tokens.pop_back();
    for (std::size_t k = 0; k < node.count; ++k) {
      lane(node, k);
    }
  }
  return ids;
}

/// A small body that touches a large one corner on corner, as one of the large body's axes points.
struct Touching {
  Shape large;
  Pose fixed;
  Shape small;
  Pose pose;
};

/// Up to 2^`reach` sizes away from the origin.
Touching touching(Rng& rng, const Mesh& many_triangles, double reach = 8) {
  const double scale = rng.below(2) ? 1 : std::exp2(rng.uniform(-1000, 280 - reach));
  const double far = rng.below(2) ? 0 : scale * std::exp2(rng.uniform(-8, reach));
  const Vec3 place{far, -0.5 * far, 0.25 * far};
  Touching two{
      Shape(test::placed(many_triangles, scale, rng.below(2) ? place : Vec3{})), Pose{},
      Shape(test::placed(test::awkward_mesh(rng, 10), scale * std::exp2(-rng.uniform(2, 14)),
                         rng.below(2) ? place : Vec3{})),
      Pose{}};
  const Pose turn = test::awkward_rotation(rng);
  two.fixed = rng.below(2) ? Pose{} : test::awkward_rotation(rng);
  two.fixed.m[7] = far * rng.unit();
  // The corner that is farthest along the axis goes to one of the large body's corners.
  const std::size_t axis = rng.below(3);
  const double sign = rng.below(2) ? 1 : -1;
  const Vec3 n = sign * Vec3{two.fixed.m[axis], two.fixed.m[4 + axis], two.fixed.m[8 + axis]};
  const MeshView& small = two.small.mesh();
  Vec3 corner = small.vertices[small.triangles[0][0]];
  for (const auto& triangle : small.triangles) {
    for (const std::uint32_t v : triangle) {
      const Vec3& p = small.vertices[v];
      corner = dot(n, turn.apply(p)) > dot(n, turn.apply(corner)) ? p : corner;
    }
  }
  const auto& vertices = two.large.mesh().vertices;
  Vec3 place_of_touch = vertices[rng.below(vertices.size())];
  if (rng.below(2)) {
    // Where nothing else of the large body is near: its outermost corner on that side.
    place_of_touch = *std::min_element(
        vertices.begin(), vertices.end(),
        [&](const Vec3& p, const Vec3& q) { return sign * p[axis] < sign * q[axis]; });
  }
  two.pose = test::moving(turn, corner, two.fixed.apply(place_of_touch));
  return two;
}

/// How many cases there were.
struct Cases {
  std::size_t alone = 0;  // the box is descended by itself
  std::size_t few = 0;    // and leads to less than a quarter of the triangles
};

void expect_leads_to_what_touches(const Touching& two, Cases& cases) {
  const auto& [large, fixed, small, pose] = two;
  const RelativePose relative(small.layout(), pose, ReferenceFrame(large.layout(), fixed));
  const Overlap expected = reference::overlap(small.mesh(), pose, large.mesh(), fixed);
  SingleBox box;
  relative.single_box(box);
  if (relative.apart() || !box.pays(large.layout().nodes()[0])) {
    ASSERT_TRUE(!relative.apart() || !expected.any);
    return;
  }
  ++cases.alone;
  PairList stack;
  PairList seeds;
  Cost cost;
  box.find_place(large.layout());
  box.descend(large.layout(), stack, seeds, cost);
  EXPECT_TRUE(stack.empty());
  EXPECT_TRUE(cost.node_tests > 0 || !seeds.empty());
  const std::set<TriangleId> found = below(seeds, large.layout());
  for (const auto& [i, j] : expected.pairs) {
    ASSERT_EQ(found.count(j), 1U);
  }
  cases.few += 4 * found.size() < large.mesh().triangles.size() ? 1U : 0U;
}

// Without a margin 2 of 288 such cases lose a triangle.
TEST(SingleBox, LeadsToEveryTriangleThatTheBodyTouches) {
  Cases cases;
  test::for_each_case("single-box/touch", 300, [&](Rng& rng) {
    const Mesh mesh = many_triangles(rng);
    expect_leads_to_what_touches(touching(rng, mesh), cases);
  });
  EXPECT_GT(cases.alone, 150U);
  EXPECT_GT(cases.few, 100U);
}

// There the rounding of moved vertices outweighs that of floats.
TEST(SingleBox, LeadsToEveryTriangleThatTheBodyTouchesFarFromTheOrigin) {
  Cases cases;
  test::for_each_case("single-box/far", 300, [&](Rng& rng) {
    const Mesh mesh = many_triangles(rng);
    expect_leads_to_what_touches(touching(rng, mesh, 45), cases);
  });
  EXPECT_GT(cases.alone, 100U);
}

/// Many triangles on hills over two axes, now and then with two triangles as wide as all of it.
Mesh many_flat_triangles(Rng& rng) {
  Mesh mesh = many_triangles(rng);
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::uint32_t wide = rng.below(3) == 0 ? 2 : 0;
  for (std::uint32_t i = 0; i < 3 * wide; ++i) {
    mesh.vertices.push_back(test::point_in(rng, {{-1, -1, -1}, {1, 1, 1}}));
  }
  for (std::uint32_t i = first; i + 2 < mesh.vertices.size(); i += 3) {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  const std::size_t axis = rng.below(3);
  const double height = std::exp2(-rng.uniform(2.1, rng.below(2) ? 4 : 20));
  for (Vec3& v : mesh.vertices) {
    const double hill = std::sin(3 * v[(axis + 1) % 3]) * std::cos(2 * v[(axis + 2) % 3]);
    v[axis] = height * (0.1 * v[axis] + 0.9 * hill);
  }
  return mesh;
}

TEST(SingleBox, LeadsToEveryTriangleOfAFlatMeshThatTheBodyTouches) {
  Cases cases;
  test::for_each_case("single-box/flat", 300, [&](Rng& rng) {
    const Mesh mesh = many_flat_triangles(rng);
    const double far = rng.below(3) == 0 ? 45 : 0;
    Touching two = touching(rng, mesh, far);
    if (two.large.layout().min_max_grid().empty() || two.large.bounds().empty()) {
      return;
    }
    const auto& [large, fixed, small, pose] = two;
    if (!reference::overlap(small.mesh(), pose, large.mesh(), fixed).any) {
      return;  // nothing to be led to: a place without triangles may end at once
    }
    expect_leads_to_what_touches(two, cases);
  });
  EXPECT_GT(cases.alone, 100U);
  EXPECT_GT(cases.few, 60U);
}

TEST(SingleBox, IsNotClearOfColumnsWhoseTrianglesItsBodyTouches) {
  std::size_t touching_cases = 0;
  std::size_t clear_cases = 0;
  test::for_each_case("single-box/columns", 400, [&](Rng& rng) {
    Touching two = touching(rng, many_flat_triangles(rng));
    ASSERT_FALSE(two.large.layout().min_max_grid().empty());
    // Or above or below, by a part of the landscape's height.
    if (rng.below(2) == 0) {
      const Vec3 extent = two.large.bounds().extent();
      const std::size_t up =
          extent.x < extent.y ? (extent.x < extent.z ? 0 : 2) : (extent.y < extent.z ? 1 : 2);
      const double off = (rng.below(2) ? 1 : -1) * extent[up] * std::exp2(-rng.uniform(0, 4));
      for (std::size_t k = 0; k < 3; ++k) {
        two.pose.m[4 * k + 3] += off * two.fixed.m[4 * k + up];
      }
    }
    const auto& [large, fixed, small, pose] = two;
    const RelativePose relative(small.layout(), pose, ReferenceFrame(large.layout(), fixed));
    SingleBox box;
    relative.single_box(box);
    if (relative.apart() || !box.pays(large.layout().nodes()[0])) {
      return;
    }
    const bool any = reference::overlap(small.mesh(), pose, large.mesh(), fixed).any;
    box.find_place(large.layout());
    const bool clear = box.clear_of(large.layout());
    ASSERT_FALSE(any && clear);
    touching_cases += any ? 1U : 0U;
    clear_cases += clear ? 1U : 0U;
  });
  EXPECT_GT(touching_cases, 100U);
  EXPECT_GT(clear_cases, 10U);
}

// Groups of queries go down side by side; which of them traversal on afterwards differs from pose
// to pose.
TEST(SingleBox, GoesDownBesideOthersAsItGoesAlone) {
  std::size_t over = 0;
  std::size_t hits = 0;
  test::for_each_case("single-box/batch", 160, [&](Rng& rng) {
    const Body large(Shape(rng.below(2) ? many_flat_triangles(rng) : many_triangles(rng)),
                     rng.below(2) ? Pose{} : test::awkward_rotation(rng));
    const Shape small(test::placed(test::awkward_mesh(rng, 10), 0.05, {}));
    std::vector<Pose> poses;
    for (std::uint64_t i = rng.below(300); i > 0; --i) {
      const Vec3 at = test::point_in(rng, large.shape.bounds());
      poses.push_back(test::moving(test::awkward_rotation(rng), {}, large.pose.apply(at)));
    }
    for (const OverlapMode mode : {OverlapMode::all, OverlapMode::any, OverlapMode::first}) {
      const OverlapBatch batch = overlap(small, poses, large, {.mode = mode});
      for (std::size_t k = 0; k < poses.size(); ++k) {
        const Overlap alone = overlap(Body(small, poses[k]), large, {.mode = mode});
        ASSERT_EQ(batch.any[k] != 0, alone.any);
        ASSERT_EQ(batch.coverage[k], alone.coverage);
        const auto pairs = batch.pairs_of(k);
        ASSERT_EQ(std::vector(pairs.begin(), pairs.end()), alone.pairs);
        ASSERT_EQ(batch.costs[k], alone.cost);
        over += alone.cost.triangle_tests == 0 ? 1U : 0U;
        hits += alone.any ? 1U : 0U;
      }
    }
  });
  EXPECT_GT(over, 1000U);
  EXPECT_GT(hits, 1000U);
}

}  // namespace
}  // namespace soms::detail
