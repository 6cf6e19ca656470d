#include "soms/base/arithmetic.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/detail/single_box_descent.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {
namespace {

/// A body of some size somewhere, flat as a city or not.
Shape small_or_flat(Rng& rng, double size) {
  const double far = rng.below(3) == 0 ? size * std::exp2(rng.uniform(0, 20)) : 0;
  const Mesh mesh = test::placed(test::awkward_mesh(rng, 30), size, {far, -far, 0.5 * far});
  if (rng.below(2) == 0) {
    return Shape(mesh);
  }
  Mesh flat = mesh;
  for (Vec3& v : flat.vertices) {
    v.z *= 0x1p-4;
  }
  return Shape(flat);
}

Pose pose_within(Rng& rng, double range) {
  Pose pose = rng.below(4) == 0 ? Pose{} : test::awkward_rotation(rng);
  for (const std::size_t k : {3U, 7U, 11U}) {
    pose.m[k] = range * rng.uniform(-1, 1);
  }
  return pose;
}

void expect_same_box(const SingleBox& a, const SingleBox& b, bool placed) {
  ASSERT_EQ(a.center, b.center);
  ASSERT_EQ(a.half, b.half);
  ASSERT_EQ(a.size, b.size);
  ASSERT_EQ(a.sum, b.sum);
  ASSERT_EQ(a.slack, b.slack);
  ASSERT_EQ(a.scale, b.scale);
  if (placed) {
    ASSERT_EQ(a.place.from, b.place.from);
    ASSERT_EQ(a.place.to, b.place.to);
    ASSERT_EQ(a.place.lower, b.place.lower);
    ASSERT_EQ(a.place.upper, b.place.upper);
  }
}

void expect_same_pose(RelativePose& a, RelativePose& b) {
  ASSERT_EQ(a.apart(), b.apart());
  ASSERT_EQ(a.residual(), b.residual());
  a.prepare();
  b.prepare();
  ASSERT_EQ(a.numbers().shift, b.numbers().shift);
  ASSERT_EQ(a.numbers().column, b.numbers().column);
  ASSERT_EQ(a.numbers().rows, b.numbers().rows);
  ASSERT_EQ(a.numbers().scale, b.numbers().scale);
  ASSERT_EQ(a.numbers().slack, b.numbers().slack);
  ASSERT_EQ(a.numbers().rounding, b.numbers().rounding);
  ASSERT_EQ(a.numbers().relative, b.numbers().relative);
  ASSERT_EQ(a.numbers().ratio, b.numbers().ratio);
}

TEST(PoseKernels, FindThePosesOfABatchAsOneByOne) {
  const PlainArithmetic plain;
  std::size_t apart = 0;
  std::size_t placed = 0;
  std::size_t outweighed = 0;
  test::for_each_case("pose-kernels/relative", 300, [&](Rng& rng) {
    const double size = rng.below(4) == 0 ? std::exp2(rng.uniform(-300, 200)) : 1;
    const Shape mover = small_or_flat(rng, size * std::exp2(-rng.uniform(0, 8)));
    const Body fixed(small_or_flat(rng, size), pose_within(rng, rng.below(2) ? 0 : size));
    const ReferenceFrame frame(fixed.shape.layout(), fixed.pose);
    const WideTree& y = fixed.shape.layout();
    const bool has_grid = !y.min_max_grid().empty();
    std::vector<Pose> poses(1 + rng.below(RelativePoses::kMost));
    std::array<const Pose*, RelativePoses::kMost> places = {};
    for (std::size_t i = 0; i < poses.size(); ++i) {
      poses[i] = pose_within(rng, size * (rng.below(4) == 0 ? std::exp2(rng.uniform(0, 60)) : 2));
      places[i] = &poses[i];
    }
    const BoxNumbers box{y.scale(), has_grid ? &y.min_max_grid().plan() : nullptr};
    for (const Kernels* kernels : kernels_here()) {
      RelativePoses found;
      kernels->relative_poses(moved_numbers(mover.layout()), frame, box, places.data(),
                              poses.size(), found);
      found.residual.fill(frame.residual);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        RelativePose expected(mover.layout(), poses[i], frame);
        RelativePose relative(mover.layout(), y, found, i);
        SingleBox expected_box;
        expected.single_box(expected_box);
        expected_box.find_place(y);
        SingleBox box_here;
        box_here.take(found, i, has_grid);
        expect_same_box(box_here, expected_box, has_grid);
        expect_same_pose(relative, expected);
        apart += expected.apart() ? 1U : 0U;
        placed += has_grid ? 1U : 0U;
        outweighed += expected.numbers().scale == 0 ? 1U : 0U;
      }
    }
  });
  EXPECT_GT(apart, 1000U);
  EXPECT_GT(placed, 1000U);
  EXPECT_GT(outweighed, 10U);
}

// Whichever body is the one in whose axes the pair is seen.
TEST(PoseKernels, MakeTheFramesThatOnePoseMakes) {
  const PlainArithmetic plain;
  std::size_t swapped = 0;
  test::for_each_case("pose-kernels/frames", 200, [&](Rng& rng) {
    const Shape mover = small_or_flat(rng, std::exp2(rng.uniform(-3, 3)));
    const Body fixed(small_or_flat(rng, 1), pose_within(rng, 1));
    std::vector<Pose> poses(1 + rng.below(RelativePoses::kMost));
    std::array<const Pose*, RelativePoses::kMost> places = {};
    for (std::size_t i = 0; i < poses.size(); ++i) {
      poses[i] = pose_within(rng, 2);
      places[i] = &poses[i];
    }
    const PoseFrames frames(mover, fixed);
    RelativePoses found;
    frames.find(std::span(places).first(poses.size()), found);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      std::optional<PairFrame> alone;
      std::optional<PairFrame> together;
      frames.place(poses[i], alone);
      frames.place(poses[i], found, i, together);
      ASSERT_EQ(together->swapped(), alone->swapped());
      ASSERT_EQ(together->x().pose, alone->x().pose);
      ASSERT_EQ(together->y().pose, alone->y().pose);
      ASSERT_EQ(together->x().shape, alone->x().shape);
      ASSERT_EQ(together->y().shape, alone->y().shape);
      SingleBox expected;
      alone->relative().single_box(expected);
      expected.find_place(alone->y().layout());
      SingleBox box;
      box.take(found, i, !alone->y().layout().min_max_grid().empty());
      expect_same_box(box, expected, !alone->y().layout().min_max_grid().empty());
      expect_same_pose(together->relative(), alone->relative());
      swapped += alone->swapped() ? 1U : 0U;
    }
  });
  EXPECT_GT(swapped, 200U);
}

/// A pose that is off a rotation or out of range, maybe by little, maybe by not enough to matter.
Pose spoiled_pose(Rng& rng, const Pose& pose) {
  Pose bad = pose;
  const std::size_t entry = rng.below(12);
  switch (rng.below(6)) {
    case 0:
      bad.m[entry] = std::numeric_limits<double>::quiet_NaN();
      break;
    case 1:
      bad.m[entry] = std::numeric_limits<double>::infinity();
      break;
    case 2:
      bad.m[4 * (entry % 3) + 3] = std::exp2(rng.uniform(299.9, 300.1));
      break;
    case 3:
      for (const std::size_t k : {0U, 4U, 8U}) {
        bad.m[k] = -bad.m[k];
      }
      break;
    case 4:
      bad.m[entry] += rng.uniform(-2e-6, 2e-6);
      break;
    default:
      bad.m[entry] *= 1 + rng.uniform(-1e-6, 1e-6);
      break;
  }
  return bad;
}

TEST(PoseKernels, PassThePosesThatPassTheirChecks) {
  const PlainArithmetic plain;
  std::size_t all = 0;
  std::size_t failed = 0;
  test::for_each_case("pose-kernels/checks", 2000, [&](Rng& rng) {
    const Shape shape =
        small_or_flat(rng, rng.below(8) == 0 ? std::exp2(rng.uniform(-300, 270)) : 1);
    std::vector<Pose> poses(1 + rng.below(40));
    for (Pose& pose : poses) {
      pose = pose_within(rng, std::exp2(rng.uniform(0, 100)));
      pose = rng.below(16) == 0 ? spoiled_pose(rng, pose) : pose;
    }
    std::size_t first = 0;
    while (first < poses.size() && passes_checks(poses[first], shape.bounds())) {
      ++first;
    }
    for (const Kernels* kernels : kernels_here()) {
      ASSERT_EQ(kernels->passing_poses(poses.data(), poses.size(), farthest(shape.bounds())), first)
          << kernels->name;
    }
    (first == poses.size() ? all : failed) += 1;
  });
  EXPECT_GT(all, 500U);
  EXPECT_GT(failed, 500U);
}

}  // namespace
}  // namespace soms::detail
