// Kernels of motions: the same bits by each instruction set, and windows that leave out what is
// apart.
#include "soms/motion/detail/kernels/motion_kernels.h"

#include "soms/query/instruction_set.h"

#include "tests/motion/detail/lanes_of.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string_view>
#include <vector>

namespace soms::detail {
namespace {

Vec3 any_point(Rng& rng, double most) {
  return {rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
}

/// Sizes from next to the least doubles to large; some triangles are needles or points.
std::vector<Triangle> any_triangles(Rng& rng, double size) {
  std::vector<Triangle> triangles;
  for (std::size_t left = 1 + rng.below(TriangleLanes::kLanes); left > 0; --left) {
    const Vec3 a = any_point(rng, size);
    const Vec3 b = rng.below(8) == 0 ? a : any_point(rng, size);
    const Vec3 c = rng.below(8) == 0 ? a + (b - a) * 0.25 : any_point(rng, size);
    triangles.push_back({a, b, c});
  }
  return triangles;
}

double any_size(Rng& rng) {
  return std::ldexp(1.0, static_cast<int>(rng.below(3) == 0 ? rng.below(500) : 300) - 300);
}

/// The way from a pose to another one, without the margins of a law.
struct MotionStretch {
  Shape mover;
  RigidMotion motion;
  Body fixed;
  RigidLaw law;
  MotionBounds bounds;
  MotionInterval interval;

  MotionStretch(const std::vector<Triangle>& triangles, const RigidMotion& way)
      : mover(test::soup_body(triangles)),
        motion(way),
        fixed(test::soup_body(triangles)),
        law(mover, motion, fixed),
        bounds(law, fixed.shape, 0),
        interval(bounds, 0.25, 0.5) {}
};

RigidMotion any_way(Rng& rng, double size) {
  const Pose start = Pose::from_axis_angle({1, 2, 3}, rng.uniform(-3, 3), any_point(rng, size));
  const Pose turn =
      Pose::from_axis_angle({3, rng.uniform(-1, 1), 1}, rng.uniform(-1, 1), any_point(rng, size));
  return RigidMotion::between(start, turn * start);
}

/// What kernels say of triangles and boxes, bit by bit.
std::vector<std::uint64_t> bits_by(std::string_view name, const MotionStretch& way,
                                   const std::vector<Triangle>& moving,
                                   const std::vector<Triangle>& resting, const SweptBoxes& boxes_x,
                                   const SweptBoxes& boxes_y) {
  const MotionKernels& kernels = motion_kernels(name);
  const double margin = way.bounds.box_margin();
  std::vector<std::uint64_t> bits;
  const auto add = [&](const TimeWindow& window) {
    bits.push_back(std::bit_cast<std::uint64_t>(window.lower));
    bits.push_back(std::bit_cast<std::uint64_t>(window.upper));
  };
  WindowsOfLanes windows;
  const auto add_all = [&] {
    bits.push_back(windows.open);
    for (std::size_t lane = 0; lane < TriangleLanes::kLanes; ++lane) {
      if ((windows.open >> lane & 1U) != 0) {
        add(windows.at(lane));
      }
    }
  };
  TriangleLanes x = test::lanes_of(moving);
  TriangleLanes y = test::lanes_of(resting);
  kernels.sweep(way.interval, margin, x);
  kernels.place(way.motion.start(), y);
  for (std::size_t j = 0; j < y.count; ++j) {
    kernels.meet_triangle(x, y, j, margin, windows);
    add_all();
  }
  kernels.meet_box(x, boxes_y, margin, windows);
  add_all();
  kernels.meet_box(y, boxes_x, margin, windows);
  add_all();
  WindowsOfPairs pairs;
  kernels.meet_nodes(boxes_x, boxes_y, margin, pairs);
  bits.push_back(pairs.open);
  for (std::size_t k = 0; k < 16; ++k) {
    if (pairs.has(k / 4, k % 4)) {
      add(pairs.at(k / 4, k % 4));
    }
  }
  return bits;
}

SweptBoxes any_boxes(Rng& rng, double size, bool moves) {
  SweptBoxes boxes = test::boxes_at(rng, {});
  boxes.count = 1 + rng.below(SweptBoxes::kLanes);
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    put_lane(any_point(rng, size), lane, boxes.center);
    put_lane(any_point(rng, moves ? size : 0), lane, boxes.change);
    put_lane(Vec3{rng.unit(), rng.unit(), rng.unit()} * (size * 0.3), lane, boxes.half);
    boxes.give[lane] = moves ? rng.unit() * 0.1 * size : 0;
  }
  return boxes;
}

TEST(MotionKernels, SayTheSameByEachInstructionSet) {
  std::size_t open = 0;
  test::for_each_case("motion-kernels/same", 2000, [&](Rng& rng) {
    const double size = any_size(rng);
    const std::vector<Triangle> moving = any_triangles(rng, size);
    const std::vector<Triangle> resting = any_triangles(rng, size);
    const MotionStretch way(moving, any_way(rng, size));
    const SweptBoxes x = any_boxes(rng, size, true);
    const SweptBoxes y = any_boxes(rng, size, false);
    const auto expected = bits_by("scalar", way, moving, resting, x, y);
    open += expected.size();
    for (const std::string_view name : instruction_sets()) {
      ASSERT_EQ(bits_by(name, way, moving, resting, x, y), expected) << name;
    }
  });
  EXPECT_GT(open, 20'000U);
}

/// Points that are seen along the axes of the world alone.
SweptBoxes upright_points(const Vec3& place, const Vec3& change, double give) {
  SweptBoxes boxes;
  boxes.count = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    boxes.axis[k] = {};
    boxes.axis[k][k] = 1;
    boxes.direction[k] = boxes.axis[k];
  }
  put_lane(place, 0, boxes.center);
  put_lane(change, 0, boxes.change);
  boxes.give[0] = give;
  return boxes;
}

TEST(MotionKernels, WindowsAreTheTimesWithinReach) {
  const SweptBoxes x = upright_points({}, {4, 0, 0}, 1);
  for (const std::string_view name : instruction_sets()) {
    WindowsOfPairs windows;
    const auto meet = [&](const Vec3& place) {
      motion_kernels(name).meet_nodes(x, upright_points(place, {}, 0), 0, windows);
      return windows.open == 1;
    };
    ASSERT_TRUE(meet({1, 0, 0}));  // |1 - 4 s| <= 1
    EXPECT_NEAR(windows.at(0, 0).lower, 0, 1e-14);
    EXPECT_LT(windows.at(0, 0).lower, 0);
    EXPECT_NEAR(windows.at(0, 0).upper, 0.5, 1e-14);
    EXPECT_GT(windows.at(0, 0).upper, 0.5);
    EXPECT_TRUE(meet({-5, 0, 0}));
    EXPECT_FALSE(meet({-5.001, 0, 0}));
    EXPECT_TRUE(meet({1, 1, -1})) << "next to the way";
    EXPECT_FALSE(meet({1, 1.001, 0})) << "beside it";
  }
}

// Points and needles have no normals, and no products of edges: what moves nowhere meets all the
// time.
TEST(MotionKernels, ADirectionOfNoLengthLeavesAllTimes) {
  const std::vector<Triangle> points{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
                                     {{1, 2, 3}, {2, 4, 6}, {3, 6, 9}}};
  const MotionStretch way(points, RigidMotion::along({}, {0, 0, 0}));
  for (const std::string_view name : instruction_sets()) {
    const MotionKernels& kernels = motion_kernels(name);
    TriangleLanes x = test::lanes_of(points);
    TriangleLanes y = test::lanes_of(points);
    kernels.sweep(way.interval, 0, x);
    kernels.place({}, y);
    WindowsOfLanes windows;
    for (std::size_t k = 0; k < 4; ++k) {
      kernels.meet_triangle(x, y, k / 2, way.bounds.box_margin(), windows);
      ASSERT_EQ(windows.open, 3U) << name;
      EXPECT_EQ(windows.at(k % 2).lower, -1) << name;
      EXPECT_EQ(windows.at(k % 2).upper, 1) << name;
    }
  }
}

// Triangles side by side, a little apart: at rest, no direction but one parts them. Without it they
// would be said to meet all the time.
TEST(MotionKernels, EachDirectionParts) {
  const Triangle flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<Triangle> others{
      {{1, 1, 0.1}, {2, 1, 0.3}, {1, 2, 0.2}},     // by the normal of the first
      {{2.1, 2.1, -1}, {2.1, 2.1, 1}, {5, 5, 0}},  // by two edges
      {{-1, 1, -1}, {-0.1, 2, 1}, {-0.2, 1, 0.3}}  // by an axis
  };
  const MotionStretch way(others, RigidMotion::along({}, {0, 0, 0}));
  for (const std::string_view name : instruction_sets()) {
    const MotionKernels& kernels = motion_kernels(name);
    TriangleLanes x = test::lanes_of(others);
    TriangleLanes y = test::lanes_of(std::vector<Triangle>{flat});
    kernels.sweep(way.interval, 0, x);
    kernels.place({}, y);
    WindowsOfLanes windows;
    kernels.meet_triangle(x, y, 0, way.bounds.box_margin(), windows);
    EXPECT_EQ(windows.open, 0U) << name;
    kernels.meet_triangle(x, y, 0, 0.5, windows);
    EXPECT_EQ(windows.open, 7U) << name;
  }
}

TEST(MotionKernels, TrianglesAreKeptInTheirOrder) {
  std::vector<Triangle> triangles;
  for (int k = 0; k < 6; ++k) {
    triangles.push_back({{1.0 * k, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  }
  TriangleLanes lanes = test::lanes_of(triangles);
  motion_kernels().place({}, lanes);
  keep_lanes(0b101001, lanes);
  ASSERT_EQ(lanes.count, 3U);
  EXPECT_EQ(lanes.id[0], 0U);
  EXPECT_EQ(lanes.id[1], 3U);
  EXPECT_EQ(lanes.id[2], 5U);
  EXPECT_EQ(lanes.corner[0][0][1], 3.0);
  EXPECT_EQ(lanes.corner[0][0][7], 5.0) << "the last one is repeated";
}

}  // namespace
}  // namespace soms::detail
