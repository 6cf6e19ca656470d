// Kernels of rays: all instruction sets give the same bits, and nothing sure is wrong.
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/parity/parity_frame.h"
#include "soms/query/detail/parity/triangle_crossing.h"
#include "soms/tree/shape.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/scales.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace soms::detail {
namespace {

/// A shape at a place, and points near it: some in its box, many beside vertices and edges.
struct Scene {
  explicit Scene(Rng& rng)
      : shape(test::placed(test::awkward_mesh(rng, 200), scale(rng), shift(rng)),
              {.build = test::awkward_options(rng)}),
        pose(rng.below(3) == 0 ? Pose{} : test::awkward_rotation(rng)) {
    if (rng.below(2) == 0) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        pose.m[4 * axis + 3] = rng.uniform(-1, 1) * std::exp2(rng.uniform(-30, 30));
      }
    }
  }

  /// Triangles of very different sizes, of a body of any size.
  Scene(Rng& rng, const test::Scales& scales)
      : shape(test::uneven_mesh(rng, scales), {.build = test::awkward_options(rng)}),
        pose(test::pose_at(rng, scales)) {}

  static Scene any(Rng& rng) {
    return rng.below(3) == 0 ? Scene(rng, test::any_scales(rng)) : Scene(rng);
  }

  static double scale(Rng& rng) {
    return rng.below(2) == 0 ? 1 : std::exp2(std::floor(rng.uniform(-60, 60)));
  }

  static Vec3 shift(Rng& rng) {
    const double far = rng.below(2) == 0 ? 0 : std::exp2(rng.uniform(-5, 25));
    return {far * rng.uniform(-1, 1), far * rng.uniform(-1, 1), far * rng.uniform(-1, 1)};
  }

  [[nodiscard]] Triangle moved(TriangleId id) const {
    const Triangle t = shape.mesh().triangle(id);
    return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
  }

  /// A point of the world, on a triangle as near as doubles allow, or off it on some axes.
  [[nodiscard]] Vec3 point(Rng& rng) const {
    const auto count = static_cast<std::uint64_t>(shape.mesh().triangles.size());
    const Triangle t = moved(static_cast<TriangleId>(rng.below(count)));
    const double u = rng.below(2) == 0 ? 0 : rng.uniform(0, 1);
    const double v = rng.below(3) == 0 ? rng.uniform(0, 1 - u) : 0;
    Vec3 p = t.a + (t.b - t.a) * u + (t.c - t.a) * v;
    const Box box = shape.bounds();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double side = box.extent()[axis];
      const std::uint64_t way = rng.below(5);
      if (way == 0) {
        p[axis] = std::nextafter(p[axis], rng.below(2) == 0 ? 1e300 : -1e300);
      } else if (way == 1) {
        p[axis] += side * rng.uniform(-0.5, 0.5) * std::exp2(-rng.uniform(0, 24));
      }
    }
    return p;
  }

  Shape shape;
  Pose pose;
};

TEST(RayKernels, OfAllInstructionSetsGiveTheSameBits) {
  std::size_t met = 0;
  test::for_each_case("ray-kernels/bits", 150, [&](Rng& rng) {
    const Scene scene = Scene::any(rng);
    const ParityFrame frame(scene.shape.layout(), scene.pose);
    std::vector<RayStart> starts;
    for (int i = 0; i < 8; ++i) {
      starts.push_back(frame.start(scene.point(rng)));
    }
    std::vector<RayNodeTask> nodes;
    std::vector<RayBlockTask> blocks;
    for (const RayStart& start : starts) {
      for (const WideNode& node : scene.shape.layout().nodes()) {
        nodes.push_back({&frame.numbers(), &start, &node, 0});
      }
      for (const TriangleBlock& block : scene.shape.layout().blocks()) {
        blocks.push_back({&frame.numbers(), &start, &block, 0, 0});
      }
    }
    std::vector<RayNodeTask> expected_nodes = nodes;
    std::vector<RayBlockTask> expected_blocks = blocks;
    scalar::kernels().ray_nodes(expected_nodes.data(), nodes.size());
    scalar::kernels().ray_blocks(expected_blocks.data(), blocks.size());
    for (const Kernels* kernels : kernels_here()) {
      SCOPED_TRACE(kernels->name);
      kernels->ray_nodes(nodes.data(), nodes.size());
      kernels->ray_blocks(blocks.data(), blocks.size());
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        ASSERT_EQ(nodes[i].lanes, expected_nodes[i].lanes);
        met += nodes[i].lanes != 0 ? 1U : 0U;
      }
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        ASSERT_EQ(blocks[i].cross, expected_blocks[i].cross);
        ASSERT_EQ(blocks[i].open, expected_blocks[i].open);
      }
    }
  });
  EXPECT_GT(met, 1000U);
}

/// What a whole tree says of triangles that the ray meets: below nodes that it may meet only.
void expect_right(const Scene& scene, const ParityFrame& frame, const Vec3& p,
                  std::array<std::size_t, 3>& counts) {
  const RayStart start = frame.start(p);
  const auto& kernels = scalar::kernels();
  const WideTree& tree = scene.shape.layout();
  std::vector<std::uint32_t> reached{0};
  std::vector<bool> decided(scene.shape.mesh().triangles.size());
  while (!reached.empty()) {
    const std::uint32_t token = reached.back();
    reached.pop_back();
    if ((token & WideNode::kLeafBit) == 0) {
      RayNodeTask task{&frame.numbers(), &start, &tree.nodes()[token], 0};
      kernels.ray_nodes(&task, 1);
      for (std::uint32_t k = 0; k < WideNode::kWidth; ++k) {
        if ((task.lanes >> k & 1U) != 0) {
          reached.push_back(task.node->child[k]);
        }
      }
      continue;
    }
    const TriangleBlock& block = tree.blocks()[token & (WideNode::kMost - 1)];
    RayBlockTask task{&frame.numbers(), &start, &block, 0, 0};
    kernels.ray_blocks(&task, 1);
    ASSERT_EQ(task.cross & task.open, 0U);
    for (std::uint32_t k = 0; k < block.count; ++k) {
      bool exact = false;
      const RayHit hit =
          triangle_crossing(scene.moved(block.id[k]), p, frame.axis(), start.sign > 0, exact);
      decided[block.id[k]] = true;
      if ((task.open >> k & 1U) != 0) {
        ++counts[0];
      } else if ((task.cross >> k & 1U) != 0) {
        ++counts[1];
        ASSERT_EQ(hit, RayHit::cross);
      } else {
        ++counts[2];
        ASSERT_EQ(hit, RayHit::miss);
      }
    }
    if (block.following != 0) {
      reached.push_back(token + 1);
    }
  }
  for (TriangleId id = 0; id < decided.size(); ++id) {
    bool exact = false;
    ASSERT_TRUE(decided[id] || triangle_crossing(scene.moved(id), p, frame.axis(), start.sign > 0,
                                                 exact) == RayHit::miss);
  }
}

TEST(RayKernels, AreNeverWrongWhereTheyAreSure) {
  std::array<std::size_t, 3> counts = {};
  test::for_each_case("ray-kernels/sure", 3000, [&](Rng& rng) {
    const Scene scene = Scene::any(rng);
    const ParityFrame frame(scene.shape.layout(), scene.pose);
    for (int i = 0; i < 10; ++i) {
      const Vec3 p = scene.point(rng);
      if (frame.outside(p)) {
        for (TriangleId id = 0; id < scene.shape.mesh().triangles.size(); ++id) {
          bool exact = false;
          ASSERT_NE(triangle_crossing(scene.moved(id), p, frame.axis(), true, exact), RayHit::on);
        }
      } else {
        ASSERT_NO_FATAL_FAILURE(expect_right(scene, frame, p, counts));
      }
    }
  });
  EXPECT_GT(counts[0], 1000U);
  EXPECT_GT(counts[1], 1000U);
  EXPECT_GT(counts[2], 1000U);
}

}  // namespace
}  // namespace soms::detail
