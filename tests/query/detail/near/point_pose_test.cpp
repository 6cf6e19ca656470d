// Keys of boxes and triangles are lower bounds, by every instruction set the same bits.
#include "soms/query/detail/near/point_pose.h"

#include "soms/base/random.h"
#include "soms/geometry/detail/point_to_triangle.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/leaf_pairs.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace soms::detail {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Looks at every key of a body and a point.
class KeyCheck {
 public:
  KeyCheck(const Body& body, const Vec3& point)
      : body_(body), point_(point), frame_(body_), pose_(frame_, point) {}

  /// The least distance of the triangles in a node.
  double node(std::uint32_t index) {
    const WideNode& node = body_.shape.layout().nodes()[index];
    const PointNodeKeys keys =
        keys_of<PointNodeKeys>(node, node.count, [&](const Kernels& kernels, PointNodeKeys& out) {
          kernels.bound_boxes(pose_.numbers(), node, out);
        });
    double least = kInfinity;
    for (std::size_t k = 0; k < node.count; ++k) {
      const std::uint32_t child = node.child[k];
      const double below = (child & WideNode::kLeafBit) != 0 ? leaf(child) : this->node(child);
      expect_bound(keys.key[k], below);
      least = std::min(least, below);
    }
    return least;
  }

  [[nodiscard]] bool far() const { return pose_.far(); }

 private:
  double leaf(std::uint32_t token) {
    double least = kInfinity;
    for (std::uint32_t at = token & (WideNode::kMost - 1);; ++at) {
      const TriangleBlock& block = body_.shape.layout().blocks()[at];
      const PointBlockKeys keys = keys_of<PointBlockKeys>(
          block, block.count, [&](const Kernels& kernels, PointBlockKeys& out) {
            kernels.bound_triangles(pose_.numbers(), block, out);
          });
      for (std::size_t k = 0; k < block.count; ++k) {
        PointToTriangle pair(point_, moved(frame_.body(), block.id[k]));
        const double distance = pair.distance().upper;
        expect_bound(keys.key[k], distance);
        least = std::min(least, distance);
      }
      if (block.following == 0) {
        return least;
      }
    }
  }

  template <class Keys, class Place, class Bound>
  Keys keys_of(const Place& place, std::size_t count, const Bound& bound) {
    Keys keys;
    if (pose_.far()) {
      pose_.far_keys(place, keys);
      return keys;
    }
    bound(*kernels_here().front(), keys);
    for (const Kernels* kernels : kernels_here()) {
      Keys same;
      bound(*kernels, same);
      EXPECT_EQ(std::memcmp(&keys.key, &same.key, count * sizeof(float)), 0) << kernels->name;
    }
    return keys;
  }

  /// What is at `distance` is not dropped where that is the limit, nor said to be farther.
  void expect_bound(float key, double distance) {
    pose_.set_limit(distance);
    EXPECT_FALSE(key > pose_.limit()) << key << " for " << distance;
    EXPECT_LE(pose_.distance_of(key), distance);
  }

  Body body_;
  Vec3 point_;
  PointFrame frame_;
  PointPose pose_;
};

TEST(PointPose, KeysAreBoundsByEveryInstructionSet) {
  int far = 0;
  test::for_each_case("point-pose/keys", 400, [&](Rng& rng) {
    const double scale = std::ldexp(1.0, static_cast<int>(rng.below(60)) - 30);
    const double shift = rng.below(3) == 0 ? 1e7 : 0;
    Mesh mesh = test::placed(test::awkward_mesh(rng, 80), scale, {shift, -shift, 0});
    if (mesh.triangles.empty()) {
      return;
    }
    const Triangle some = mesh.triangle(static_cast<TriangleId>(rng.below(mesh.triangles.size())));
    const Body body(Shape(std::move(mesh), {.build = test::awkward_options(rng)}),
                    test::awkward_rotation(rng));
    const double reach = scale * std::ldexp(1.0, static_cast<int>(rng.below(50)) - 20);
    const Vec3 by{rng.uniform(-reach, reach), rng.uniform(-reach, reach),
                  rng.uniform(-reach, reach)};
    KeyCheck check(body, body.pose.apply(some.a) + by);
    check.node(0);
    far += check.far() ? 1 : 0;
  });
  EXPECT_GT(far, 50);
}

TEST(PointPose, KnowsNoDistanceWhereRoundingOutweighsTheBody) {
  const Body body(test::soup_body({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
  const PointFrame frame(body);
  PointPose pose(frame, {0x1p200, 0, 0});
  EXPECT_EQ(pose.distance_of(1), 0);
  pose.set_limit(1);
  EXPECT_FALSE(pose.far());
  KeyCheck(body, {0x1p200, 0, 0}).node(0);
}

}  // namespace
}  // namespace soms::detail
