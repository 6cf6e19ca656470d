#include "bench/peers/scenarios/gap.h"

#include "soms/query/overlap.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"
#include "tests/support/support.h"

namespace soms::bench {
namespace {

FloatMesh one_triangle(const std::array<float, 3>& a, const std::array<float, 3>& b,
                       const std::array<float, 3>& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

TEST(GapTree, MeasuresCornerToFaceAndEdgeToEdge) {
  const GapTree floor(one_triangle({-4, -4, 0}, {4, -4, 0}, {0, 8, 0}));
  const GapTree spike(one_triangle({0, 0, 0}, {1, 0, 5}, {0, 1, 5}));
  EXPECT_DOUBLE_EQ(floor.distance(spike, Pose::translation(0, 0, 3), 100), 3);
  const GapTree along_x(one_triangle({-1, 0, 0}, {1, 0, 0}, {0, 0, -9}));
  const GapTree along_y(one_triangle({0, -1, 0}, {0, 1, 0}, {0, 0, 9}));
  EXPECT_DOUBLE_EQ(along_x.distance(along_y, Pose::translation(0, 0, 0.25), 100), 0.25);
}

TEST(GapTree, StopsAtEnough) {
  const GapTree cube(box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(cube.distance(cube, Pose::translation(10, 0, 0), 0.5), 0.5);
  EXPECT_DOUBLE_EQ(cube.distance(cube, Pose::translation(10, 0, 0), 100), 8);
}

TEST(NearMisses, LeaveTheGapThatTheirNameSays) {
  const Scene scene = knot_scene(1'000);
  const GapTree tree(scene.fixed);
  const Body twin([&] {
    Mesh mesh;
    for (const auto& v : scene.fixed.vertices) {
      mesh.vertices.push_back(wide(v));
    }
    mesh.triangles = scene.fixed.triangles;
    return mesh;
  }());
  for (const auto& [set, gap] : {std::pair{std::size_t{2}, 0.001}, {std::size_t{3}, 0.01}}) {
    ASSERT_EQ(scene.sets[set].poses.size(), kPoses);
    for (std::size_t i = 0; i < kPoses; i += 97) {
      const Pose& pose = scene.sets[set].poses[i];
      EXPECT_NEAR(tree.distance(tree, pose, 1), gap, 0.02 * gap) << scene.sets[set].name << i;
      Body knot = twin;
      knot.pose = pose;
      EXPECT_FALSE(overlap(knot, twin).any);
    }
  }
}

}  // namespace
}  // namespace soms::bench
