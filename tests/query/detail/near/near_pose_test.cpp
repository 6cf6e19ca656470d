#include "soms/query/detail/near/near_pose.h"

#include "soms/geometry/triangle_distance.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/leaf_pairs.h"

#include "tests/query/margins/gap.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace soms::detail {
namespace {

using Wider = long double;

constexpr float kEndless = std::numeric_limits<float>::infinity();

/// The largest factor by which `m`, nearly a rotation, lengthens a vector.
Wider largest_factor(const Matrix3& m) {
  std::array<std::array<Wider, 3>, 3> off{};  // m^T m - I
  Wider shift = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      off[i][j] = Wider{m[0][i]} * m[0][j] + Wider{m[1][i]} * m[1][j] + Wider{m[2][i]} * m[2][j] -
                  (i == j ? 1 : 0);
      shift += std::abs(off[i][j]);
    }
  }
  std::array<Wider, 3> v{0.6L, 0.64L, 0.48L};
  Wider most = 0;
  for (int step = 0; shift > 0 && step < 200; ++step) {
    std::array<Wider, 3> next{};
    for (std::size_t i = 0; i < 3; ++i) {
      next[i] = off[i][0] * v[0] + off[i][1] * v[1] + off[i][2] * v[2] + shift * v[i];
    }
    most = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
    v = {next[0] / most, next[1] / most, next[2] / most};
  }
  return std::sqrt(1 + (most - shift));
}

/// The identity with `by` added to every entry.
Pose all_entries_moved(double by) {
  Pose pose;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      pose.m[4 * i + j] += by;
    }
  }
  return pose;
}

Shape unit_triangle() {
  return test::shape_of({{-1, -1, -1}, {1, 1, 1}, {1, -1, 0.5}});
}

/// What the limit grants beside the offset's share, for a distance of 1.
Wider stretch_of(const NearPose& pose) {
  return Wider{pose.limit()} / (1 + 1.5L * Wider{pose.numbers().relative});
}

// R shrinks lengths by 1.5e-6, and its inverse lengthens them by as much.
TEST(NearPose, LimitGrantsWhatPosesStretch) {
  Wider largest = 0;
  const auto expect_granted = [&](const Pose& pose_y) {
    check(pose_y);
    const Shape body = unit_triangle();
    test::Seen seen(body, Pose::translation(3, 0, 0), body, pose_y);
    seen.pose.set_limit(1);
    const ReferenceFrame frame(body.layout(), *seen.frame.y().pose);
    const Wider factor = largest_factor(frame.inverse);
    largest = std::max(largest, factor);
    ASSERT_GE(stretch_of(seen.pose), factor);
    // The least distance at which this key is possible.
    const Wider longest = factor * (1 + 1.5L * Wider{seen.pose.numbers().relative});
    ASSERT_LE(seen.pose.distance_of(1) * longest, 1);
  };
  ASSERT_NO_FATAL_FAILURE(expect_granted(all_entries_moved(-0.4999e-6)));
  EXPECT_GT(largest, 1 + 1.49e-6L);
  test::for_each_case("near-pose/stretch", 200, [&](Rng& rng) {
    ASSERT_NO_FATAL_FAILURE(expect_granted(test::awkward_rotation(rng)));
  });
}

// The proof asks nothing of the inverse but its residual.
TEST(NearPose, LimitGrantsWhatABadInverseStretches) {
  const Shape body = unit_triangle();
  const Pose pose_x = Pose::translation(3, 0, 0);
  const Pose pose_y;
  ReferenceFrame reference(body.layout(), pose_y);
  reference.rotated = true;
  reference.inverse = rotation(all_entries_moved(1e-6));
  reference.residual = 1e-6;
  PairFrame frame({&body, &pose_x}, {&body, &pose_y}, reference, false);
  NearPose pose(frame);
  pose.set_limit(1);
  EXPECT_GT(largest_factor(reference.inverse), 1 + 2.99e-6L);
  EXPECT_GE(stretch_of(pose), largest_factor(reference.inverse));
}

// Lengths seen in the axes of either node, in floats, are at most |X g| once they are shrunk.
TEST(NearPose, ShrinkingMakesUpForAxesAndRoundings) {
  Wider largest = 0;
  const auto expect_shrunk = [&](const Pose& pose_x, const Pose& pose_y) {
    const Shape body = unit_triangle();
    const test::Seen seen(body, pose_x, body, pose_y);
    const PoseNumbers& numbers = seen.pose.numbers();
    Matrix3 turn{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        turn[i][j] = numbers.column[j][i];
      }
    }
    const Wider factor = largest_factor(turn);
    largest = std::max(largest, factor);
    ASSERT_LE(factor * numbers.shrink * (1 + 0x1p-20L), 1);
  };
  ASSERT_NO_FATAL_FAILURE(
      expect_shrunk(all_entries_moved(0.4999e-6), all_entries_moved(-0.4999e-6)));
  EXPECT_GT(largest, 1 + 2.99e-6L);
  test::for_each_case("near-pose/shrink", 200, [&](Rng& rng) {
    const Pose pose_x = test::awkward_rotation(rng);
    ASSERT_NO_FATAL_FAILURE(expect_shrunk(pose_x, test::awkward_rotation(rng)));
  });
}

// Distances are rounded down by 2^-40; where a far body's limit, what is left without its base, is
// small beside that, nothing can be seen of its own rounding.
TEST(NearPose, AKeyBeyondTheLimitIsBeyondTheDistance) {
  std::size_t far = 0;
  test::for_each_case("near-pose/limit", 1500, [&](Rng& rng) {
    const test::Gap gap =
        rng.below(2) == 0 ? test::random_gap(rng, 2) : test::random_far_gap(rng, 2);
    test::Seen seen(test::shape_of(gap.x), gap.pose_x, test::shape_of(gap.y), gap.pose_y);
    const double unit = seen.pose.numbers().scale;
    if (unit == 0 ||
        (seen.pose.far() && std::abs(seen.pose.limit()) < 0x1p-12 * seen.distance * unit)) {
      return;
    }
    far += seen.pose.far() ? 1U : 0U;
    ASSERT_GT(seen.pose.distance_of(std::nextafter(seen.pose.limit(), kEndless)), seen.distance);
  });
  EXPECT_GT(far, 100U);
}

// Where the rounding of poses outweighs the bodies nothing is known of a distance, and all passes.
TEST(NearPose, KnowsNothingWhereRoundingOutweighsTheBodies) {
  const Shape body = unit_triangle();
  const Pose place = Pose::translation(0x1p120, 0, 0);
  test::Seen seen(body, place, body, Pose::translation(0x1p120, 0x1p90, 0));
  EXPECT_EQ(seen.pose.numbers().scale, 0);
  EXPECT_FALSE(seen.pose.far());
  EXPECT_EQ(seen.pose.distance_of(0x1p100F), 0);
  for (const double upper : {0.0, 1.0, std::numeric_limits<double>::infinity()}) {
    seen.pose.set_limit(upper);
    const test::Bounds bounds = test::bounds_of(seen, kernels());
    EXPECT_TRUE(bounds.nodes && bounds.slabs && bounds.boxes && bounds.pairs) << upper;
  }
}

/// What far keys claim: no more than the distance, and no more than its limit.
void expect_far_bounds(const test::Gap& gap, std::size_t& tried) {
  const test::Seen seen(test::shape_of(gap.x), gap.pose_x, test::shape_of(gap.y), gap.pose_y);
  if (!seen.pose.far()) {
    return;
  }
  ++tried;
  const test::FarBounds bounds = test::far_bounds_of(seen);
  for (const float key : {bounds.of_nodes, bounds.of_triangles}) {
    ASSERT_LE(key, seen.pose.limit());
    ASSERT_LE(seen.pose.distance_of(key), seen.distance);
  }
}

TEST(NearPose, FarKeysAreBounds) {
  std::size_t tried = 0;
  test::for_each_case("near-pose/far", 3000, [&](Rng& rng) {
    const double far = rng.below(2) == 0 ? 2 : std::exp2(rng.uniform(1, 70));
    ASSERT_NO_FATAL_FAILURE(expect_far_bounds(test::random_far_gap(rng, far), tried));
  });
  EXPECT_GT(tried, 1000U);
}

/// Points of a ball, a leaf each: far smaller than what is left of a key without its base.
Shape points_of_a_ball(Rng& rng) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 12; ++i) {
    mesh.vertices.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
    mesh.triangles.push_back({i, i, i});
  }
  ShapeOptions options;
  options.build.per_leaf = 1;
  return Shape(mesh, options);
}

TEST(NearPose, FarKeysAreBoundsOfSmallParts) {
  test::for_each_case("near-pose/far-parts", 60, [](Rng& rng) {
    const Body a(points_of_a_ball(rng), test::awkward_rotation(rng));
    const Body b(points_of_a_ball(rng),
                 test::moving(test::awkward_rotation(rng), {}, {200, rng.uniform(-200, 200), 30}));
    PairFrame frame(a, b);
    const NearPose pose(frame);
    ASSERT_TRUE(pose.far());
    for (const TriangleBlock& x : frame.x().layout().blocks()) {
      for (const TriangleBlock& y : frame.y().layout().blocks()) {
        NearPose::BlockKeys keys;
        pose.far_keys(x, y, keys);
        const Bracket distance =
            triangle_distance(moved(frame.x(), x.id[0]), moved(frame.y(), y.id[0])).distance;
        ASSERT_LE(pose.distance_of(keys[0][0]), distance.upper);
      }
    }
  });
}

/// Points of one leaf, in a plane through the middle of their box.
struct FlatPoints {
  FlatPoints(Rng& rng, const Vec3& way) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = cross(way, {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
      points.push_back(p);
      points.push_back(-p);
    }
  }

  /// Moved back by the rotation that will move them there.
  [[nodiscard]] Shape seen_from(const Pose& pose) const {
    const auto& m = pose.m;
    Mesh mesh;
    for (const Vec3& p : points) {
      const auto i = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back({m[0] * p.x + m[4] * p.y + m[8] * p.z,
                               m[1] * p.x + m[5] * p.y + m[9] * p.z,
                               m[2] * p.x + m[6] * p.y + m[10] * p.z});
      mesh.triangles.push_back({i, i, i});
    }
    return Shape(mesh);
  }

  std::vector<Vec3> points;
};

// Beside their rounding hardly anything is left of keys without their base.
TEST(NearPose, FarKeysAreBoundsOfFlatBodies) {
  test::for_each_case("near-pose/far-flat", 60, [](Rng& rng) {
    Vec3 way{rng.uniform(-1, 1), rng.uniform(-1, 1), 1};
    way = way * (1 / std::sqrt(dot(way, way)));
    const FlatPoints flat(rng, way);
    const Pose turn_a = test::awkward_rotation(rng);
    const Pose turn_b = test::awkward_rotation(rng);
    const Body a(flat.seen_from(turn_a), turn_a);
    const Body b(flat.seen_from(turn_b), test::moving(turn_b, {}, 200 * way));
    PairFrame frame(a, b);
    const NearPose pose(frame);
    ASSERT_TRUE(pose.far());
    const TriangleBlock& x = frame.x().layout().blocks()[0];
    const TriangleBlock& y = frame.y().layout().blocks()[0];
    NearPose::BlockKeys keys;
    pose.far_keys(x, y, keys);
    for (std::size_t i = 0; i < x.count; ++i) {
      for (std::size_t k = 0; k < y.count; ++k) {
        const Bracket distance =
            triangle_distance(moved(frame.x(), x.id[i]), moved(frame.y(), y.id[k])).distance;
        ASSERT_LE(pose.distance_of(keys[i][k]), distance.upper);
      }
    }
  });
}

}  // namespace
}  // namespace soms::detail
