#include "soms/query/detail/kernels/kernels.h"

#include "soms/base/error.h"
#include "soms/query/detail/block_against_box.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/shape.h"

#include "tests/query/margins/touch.h"
#include "tests/support/support.h"

#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace soms::detail {
namespace {

/// Triangles of many sizes on a bent surface: some nodes are oriented, some are not.
Mesh surface(Rng& rng, std::size_t triangles, double scale) {
  Mesh mesh;
  for (std::size_t i = 0; i < triangles; ++i) {
    const double u = rng.uniform(-2, 2);
    const double v = rng.uniform(-1, 1);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double size = std::exp2(-rng.uniform(2, 8));
    for (int corner = 0; corner < 3; ++corner) {
      const double s = u + rng.uniform(-size, size);
      const double t = v + rng.uniform(-size, size);
      mesh.vertices.push_back(scale * Vec3{s, t + 0.5 * s, std::sin(s) + 0.2 * t * t});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Pose random_pose(Rng& rng, double range) {
  const auto part = [&] { return rng.uniform(-1, 1); };
  const std::array<double, 4> q{part() + 1.5, part(), part(), part()};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return Pose::from_quaternion(q[0] / length, q[1] / length, q[2] / length, q[3] / length,
                               {range * part(), range * part(), range * part()});
}

/// Two shapes close to each other, the one in whose axes a pair is seen first.
struct Pair {
  explicit Pair(Rng& rng)
      : reference(surface(rng, 1 + rng.below(300), 1)),
        other(surface(rng, 1 + rng.below(300), rng.below(3) == 0 ? 0x1p-30 : 0.5)) {
    relative.emplace(other.layout(), random_pose(rng, 1.5),
                     ReferenceFrame(reference.layout(), random_pose(rng, 0)));
    relative->prepare();
  }

  Shape reference;
  Shape other;
  std::optional<RelativePose> relative;
};

template <class Of>
const auto& pick(Rng& rng, const Of& of) {
  return of[rng.below(of.size())];
}

TEST(Kernels, GiveTheSameBitsOnEveryInstructionSet) {
  const std::vector<const Kernels*> all = kernels_here();
  std::size_t met = 0;
  std::size_t parted = 0;
  test::for_each_case("kernels/same", 200, [&](Rng& rng) {
    const Pair pair(rng);
    const WideTree& x = pair.other.layout();
    const WideTree& y = pair.reference.layout();
    std::vector<NodeTask> tasks;
    std::vector<NodeTask> tested;
    for (int repeat = 0; repeat < 40; ++repeat) {
      const auto index_x = static_cast<std::uint32_t>(rng.below(x.nodes().size()));
      const auto index_y = static_cast<std::uint32_t>(rng.below(y.nodes().size()));
      const WideNode& node_x = x.nodes()[index_x];
      const WideNode& node_y = y.nodes()[index_y];
      const std::uint32_t lanes =
          kLanePairs.bits[(1U << node_x.count) - 1][(1U << node_y.count) - 1];
      const NodeTask task{&pair.relative->numbers(),
                          &node_x,
                          &node_y,
                          index_x << 3,
                          index_y << 3,
                          lanes,
                          static_cast<std::uint32_t>(rng.below(2)),
                          0};
      const BlockTask blocks{
          &pair.relative->numbers(), &pick(rng, x.blocks()), &pick(rng, y.blocks()), {}, 0, 0, 0};
      NodeTask nodes_here = task;
      NodeTask larger_here = task;
      larger_here.pairs = (1U << (task.descends_x() ? node_x : node_y).count) - 1;
      const NodeTask larger = larger_here;
      BlockTask blocks_here = blocks;
      all[0]->test_nodes(&nodes_here, 1);
      all[0]->test_larger(&larger_here, 1);
      all[0]->test_slabs(&blocks_here, 1);
      TriangleSlot slot_here;
      const std::uint64_t rows = all[0]->test_boxes(blocks_here, slot_here);
      met += nodes_here.pairs != 0 ? 1 : 0;
      parted += nodes_here.pairs != lanes ? 1 : 0;
      for (const Kernels* kernels : all) {
        NodeTask nodes_there = task;
        NodeTask larger_there = larger;
        BlockTask blocks_there = blocks;
        kernels->test_nodes(&nodes_there, 1);
        kernels->test_larger(&larger_there, 1);
        kernels->test_slabs(&blocks_there, 1);
        ASSERT_EQ(nodes_there.pairs, nodes_here.pairs) << kernels->name;
        ASSERT_EQ(nodes_there.below, nodes_here.below) << kernels->name;
        ASSERT_EQ(larger_there.pairs, larger_here.pairs) << kernels->name;
        ASSERT_EQ(blocks_there.offset, blocks_here.offset) << kernels->name;
        ASSERT_EQ(blocks_there.margin, blocks_here.margin) << kernels->name;
        ASSERT_EQ(blocks_there.lanes_x, blocks_here.lanes_x) << kernels->name;
        ASSERT_EQ(blocks_there.lanes_y, blocks_here.lanes_y) << kernels->name;
        TriangleSlot slot_there;
        ASSERT_EQ(kernels->test_boxes(blocks_here, slot_there), rows) << kernels->name;
      }
      tasks.push_back(task);
      tested.push_back(nodes_here);
    }
    for (const Kernels* kernels : all) {
      std::vector<NodeTask> together = tasks;
      together.resize(tasks.size() - rng.below(8));
      kernels->test_nodes(together.data(), together.size());
      for (std::size_t i = 0; i < together.size(); ++i) {
        ASSERT_EQ(together[i].pairs, tested[i].pairs) << kernels->name;
        ASSERT_EQ(together[i].below, tested[i].below) << kernels->name;
      }
    }
  });
  EXPECT_GT(met, 100U);
  EXPECT_GT(parted, 100U);
}

// The distance is taken again in double, in the mesh's axes instead of the node's.
TEST(Kernels, HoldBoxesAgainstTrianglesTheSameOnEveryInstructionSet) {
  std::size_t met = 0;
  std::size_t parted = 0;
  test::for_each_case("kernels/boxes", 400, [&](Rng& rng) {
    const Pair pair(rng);
    const WideTree& x = pair.other.layout();
    const WideTree& y = pair.reference.layout();
    for (int repeat = 0; repeat < 20; ++repeat) {
      BoxRelation relation;
      const TriangleBlock& block_x = pick(rng, x.blocks());
      const TriangleBlock& block_y = pick(rng, y.blocks());
      const WideNode& node_x = pick(rng, x.nodes());
      const WideNode& node_y = pick(rng, y.nodes());
      const float reach = rng.below(2) == 0 ? 0 : static_cast<float>(0x1p20 * rng.unit());
      pair.relative->relate(node_x, block_y, relation);
      const SeenBox by_y = seen_by_y(relation, node_x.own_half(), reach);
      pair.relative->relate(block_x, node_y, relation);
      const SeenBox by_x = seen_by_x(relation, node_y.own_half(), reach);
      const std::uint32_t in_y = scalar::kernels().meet_box(by_y, block_y, 1);
      const std::uint32_t in_x = scalar::kernels().meet_box(by_x, block_x, relation.ratio);
      met += (in_y | in_x) != 0 ? 1 : 0;
      parted += in_y != (1U << block_y.count) - 1 || in_x != (1U << block_x.count) - 1 ? 1 : 0;
      for (const Kernels* kernels : kernels_here()) {
        ASSERT_EQ(kernels->meet_box(by_y, block_y, 1), in_y) << kernels->name;
        ASSERT_EQ(kernels->meet_box(by_x, block_x, relation.ratio), in_x) << kernels->name;
      }
    }
  });
  EXPECT_GT(met, 400U);
  EXPECT_GT(parted, 2000U);
}

TEST(Kernels, FindTheNearestPairThatMeets) {
  std::size_t found = 0;
  test::for_each_case("kernels/nearest", 200, [&](Rng& rng) {
    const Pair pair(rng);
    const WideNode& x = pair.other.layout().nodes()[0];
    const WideNode& y = pair.reference.layout().nodes()[0];
    const PoseNumbers& pose = pair.relative->numbers();
    const std::uint32_t lanes = kLanePairs.bits[(1U << x.count) - 1][(1U << y.count) - 1];
    NodeTask task{&pose, &x, &y, 0, 0, lanes, 1, 0};
    kernels().test_nodes(&task, 1);
    if (task.node_ids() == 0) {
      return;
    }
    const std::array<float, 3> offset = pose.offset(x.origin, y.origin);
    const auto center = [](const WideNode& node, std::size_t lane, std::size_t axis) {
      double sum = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        sum += double{node.row[axis][j]} * double{node.center[j][lane]};
      }
      return sum;
    };
    const auto distance = [&](std::uint32_t bit) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double between = double{offset[axis]} - center(y, (bit + (bit >> 2)) & 3, axis);
        for (std::size_t k = 0; k < 3; ++k) {
          between += double{pose.n(axis, k)} * double{pose.ratio} * center(x, bit & 3, k);
        }
        sum += between * between;
      }
      return sum;
    };
    const auto nearest = static_cast<std::uint32_t>(std::popcount(task.below));
    ASSERT_NE(task.node_ids() >> nearest & 1U, 0U);
    for (std::uint32_t bit = 0; bit < 16; ++bit) {
      if ((task.node_ids() >> bit & 1U) != 0) {
        ++found;
        EXPECT_LE(distance(nearest), distance(bit) * (1 + 1e-4) + 1e-9);
      }
    }
  });
  EXPECT_GT(found, 200U);
}

/// Two points, each a leaf: boxes without size in a node as large as their distance.
Shape two_points(const Vec3& first, const Vec3& second) {
  Mesh mesh;
  mesh.vertices = {first, second};
  mesh.triangles = {{0, 0, 0}, {1, 1, 1}};
  ShapeOptions options;
  options.build.per_leaf = 1;
  return Shape(mesh, options);
}

/// The root's lane that holds triangle 0.
std::uint32_t lane_of_first(const WideTree& tree) {
  const WideNode& root = tree.nodes()[0];
  std::uint32_t lane = 0;
  while (tree.blocks()[root.child[lane] & (WideNode::kMost - 1)].id[0] != 0) {
    ++lane;
  }
  return lane;
}

// Near the origin, where nearly all that is granted is for the rounding of floats.
TEST(Kernels, KeepPointsThatTouchAtACorner) {
  std::array<std::size_t, 2> larger{};  // how often x or y was
  test::for_each_case("kernels/touch", 6000, [&](Rng& rng) {
    test::Touch touch = test::random_touch(rng, 0.5);
    if (!test::bring_together(touch)) {
      return;
    }
    const Shape x = two_points(touch.x, touch.end_x);
    const Shape y = two_points(touch.y, touch.end_y);
    RelativePose relative(x.layout(), touch.pose_x, ReferenceFrame(y.layout(), touch.pose_y));
    relative.prepare();
    const std::uint32_t lane_x = lane_of_first(x.layout());
    const std::uint32_t lane_y = lane_of_first(y.layout());
    NodeTask task{&relative.numbers(),
                  x.layout().nodes().data(),
                  y.layout().nodes().data(),
                  0,
                  0,
                  pairs_of_lanes(1U << lane_x, 1U << lane_y),
                  0,
                  0};
    NodeTask alone = task;
    alone.pairs = 1U << (task.descends_x() ? lane_x : lane_y);
    ++larger[task.descends_x() ? 0 : 1];
    for (const Kernels* kernels : kernels_here()) {
      NodeTask both = task;
      kernels->test_nodes(&both, 1);
      ASSERT_EQ(both.pairs, task.pairs) << kernels->name;
      NodeTask one = alone;
      kernels->test_larger(&one, 1);
      ASSERT_EQ(one.pairs, alone.pairs) << kernels->name;
    }
  });
  EXPECT_GT(larger[0], 500U);
  EXPECT_GT(larger[1], 500U);
}

TEST(Kernels, AppendTheSamePairsInTheSameOrder) {
  test::for_each_case("kernels/append", 200, [](Rng& rng) {
    const Pair pair(rng);
    std::vector<NodeTask> tasks;
    for (std::size_t i = 0; i < 1 + rng.below(8); ++i) {
      const auto index_x =
          static_cast<std::uint32_t>(rng.below(pair.other.layout().nodes().size()));
      const auto index_y =
          static_cast<std::uint32_t>(rng.below(pair.reference.layout().nodes().size()));
      const WideNode& x = pair.other.layout().nodes()[index_x];
      const WideNode& y = pair.reference.layout().nodes()[index_y];
      const std::uint32_t lanes = kLanePairs.bits[(1U << x.count) - 1][(1U << y.count) - 1];
      tasks.push_back({&pair.relative->numbers(), &x, &y, index_x << 3, index_y << 3,
                       lanes & static_cast<std::uint32_t>(rng.below(0x10000)),
                       static_cast<std::uint32_t>(rng.below(2)), ~0U});
      // Any of the pairs may be the nearest.
      std::uint32_t left = tasks.back().node_ids();
      while ((left & (left - 1)) != 0 && rng.below(3) != 0) {
        left &= left - 1;
      }
      tasks.back().below = (left & (0 - left)) - 1;
    }
    const auto appended = [&](const Kernels& kernels) {
      std::array<std::vector<std::uint32_t>, 4> lists;
      for (auto& list : lists) {
        list.resize(16 * (tasks.size() + 1));
      }
      PairSink sink{lists[0].data(), lists[1].data(), lists[2].data(), lists[3].data()};
      kernels.append(tasks.data(), tasks.size(), sink);
      lists[0].resize(sink.node_ids);
      lists[1].resize(sink.node_ids);
      lists[2].resize(sink.blocks);
      lists[3].resize(sink.blocks);
      return lists;
    };
    for (const Kernels* kernels : kernels_here()) {
      ASSERT_EQ(appended(*kernels), appended(scalar::kernels())) << kernels->name;
    }
  });
}

TEST(Kernels, AreFoundByNameOrRefusedWithWhatIsThere) {
  for (const Kernels* kernels : kernels_here()) {
    EXPECT_EQ(&kernels_named(kernels->name), kernels);
  }
  const auto kind = [](std::string_view name) {
    try {
      static_cast<void>(kernels_named(name));
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("scalar"), std::string::npos);
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  EXPECT_EQ(kind("mmx"), ErrorKind::usage);
  EXPECT_EQ(kind("AVX2"), ErrorKind::usage);
#if defined(__x86_64__)
  EXPECT_EQ(kind("neon"), ErrorKind::unsupported);
#else
  EXPECT_EQ(kind("avx2"), ErrorKind::unsupported);
#endif
}

}  // namespace
}  // namespace soms::detail
