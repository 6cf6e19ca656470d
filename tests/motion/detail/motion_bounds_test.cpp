// What the proof of motion_bounds.h claims, on motions of all kinds: chords, curvature, windows.
#include "soms/motion/detail/motion_bounds.h"

#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/swept_boxes.h"
#include "soms/query/instruction_set.h"

#include "tests/motion/detail/lanes_of.h"
#include "tests/motion/place_by_law.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace soms::detail {
namespace {

using test::Far3;
using test::place_by_law;

/// A motion, and a body of some size somewhere.
struct MotionCase {
  Shape mover;
  RigidMotion motion;
  Body fixed;
  RigidLaw law;
  MotionBounds bounds;

  MotionCase(const Mesh& mesh, RigidMotion m)
      : mover(mesh),
        motion(m),
        fixed(test::box_body({-1, -1, -1}, {1, 1, 1})),
        law(mover, motion, fixed),
        bounds(law, fixed.shape, 0) {}
};

MotionCase any_motion_case(Rng& rng) {
  constexpr std::array kFarOff{0.0, 0.0, 1e3, 1e7};
  constexpr std::array kAngles{3.1, 1.0, 1e-3, 1e-9};
  const double far = kFarOff[rng.below(kFarOff.size())];
  const auto any = [&](double most) {
    return Vec3{rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
  };
  const Vec3 place = any(far);
  const Mesh mesh = test::mapped(test::box_body({-1, -2, -1}, {2, 1, 3}),
                                 [&](const Vec3& v) { return v + place; });
  const double angle = rng.uniform(-1, 1) * kAngles[rng.below(kAngles.size())];
  const Pose start = Pose::from_axis_angle(any(1) + Vec3{0, 0, 2}, rng.uniform(-3, 3), any(far));
  const Pose turn = Pose::from_axis_angle(any(1) + Vec3{0, 2, 0}, angle, any(1 + far));
  if (rng.below(4) == 0) {
    return {mesh, RigidMotion::along(start, any(3 + far))};
  }
  return {mesh, RigidMotion::between(start, turn * start, any(far + 1))};
}

double distance_from(const Far3& a, const Vec3& b) {
  return static_cast<double>(std::hypot(a[0] - b.x, a[1] - b.y, a[2] - b.z));
}

TEST(MotionBounds, PosesAreWithinTheSlackOfTheLaw) {
  test::for_each_case("motion-bounds/slack", 500, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const double t = rng.unit();
    for (const Vec3& v : c.mover.mesh().vertices) {
      ASSERT_LE(distance_from(place_by_law(c.motion, v, t), c.motion.law_at(t).apply(v)),
                c.law.slack());
    }
  });
}

// Chords of long and short stretches; the bound is not only safe, but of the size of what it
// bounds.
TEST(MotionBounds, PointsAreNearTheChord) {
  double greatest_share = 0;
  test::for_each_case("motion-bounds/chord", 1000, [&](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const double from = rng.below(2) == 0 ? 0 : rng.uniform(0, 0.9);
    const double to = rng.below(2) == 0 ? 1 : rng.uniform(from, 1);
    const MotionInterval interval(c.bounds, from, to);
    for (const Vec3& v : c.mover.mesh().vertices) {
      const double bound = interval.bow.of(c.law.arm(v)) + 2 * c.law.slack();
      for (const double s : {-0.9, -0.5, 0.0, 0.3, rng.uniform(-1, 1)}) {
        const Vec3 chord = mapped(interval.mean, v) + mapped(interval.change, v) * s;
        const double off =
            distance_from(place_by_law(c.motion, v, interval.middle + s * interval.half), chord);
        ASSERT_LE(off, bound);
        greatest_share = std::max(greatest_share, off / bound);
      }
    }
  });
  EXPECT_GT(greatest_share, 0.5);
}

// A floor is not neared by what turns above it: what counts is the part of a direction across the
// axis. Directions are next to the axis, and any.
TEST(MotionBounds, PointsLeaveTheChordAcrossTheAxis) {
  double greatest_share = 0;
  test::for_each_case("motion-bounds/across", 1000, [&](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    if (c.motion.straight()) {
      return;
    }
    const MotionInterval interval(c.bounds, 0.25, rng.uniform(0.3, 1));
    const Vec3 axis = turned(c.motion.law_at(0.5), axis_between(c.motion.from(), c.motion.to()));
    const Vec3 aside{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Vec3 n = direction_of(direction_of(axis) + aside * std::pow(10, -rng.uniform(0, 12)));
    for (const Vec3& v : c.mover.mesh().vertices) {
      const double bound = interval.bow.of(c.law.arm(v)) * c.law.across(n) + 2 * c.law.slack();
      const double s = rng.uniform(-1, 1);
      const Vec3 chord = mapped(interval.mean, v) + mapped(interval.change, v) * s;
      const Far3 place = place_by_law(c.motion, v, interval.middle + s * interval.half);
      const long double off =
          n.x * (place[0] - chord.x) + n.y * (place[1] - chord.y) + n.z * (place[2] - chord.z);
      ASSERT_LE(std::abs(static_cast<double>(off)), bound);
      greatest_share = std::max(greatest_share, std::abs(static_cast<double>(off)) / bound);
    }
  });
  EXPECT_GT(greatest_share, 0.3);
}

// The law turns faster in the middle: its acceleration has a part along the way, too.
TEST(MotionBounds, CurvatureKnowsHowTheSpeedGrows) {
  test::for_each_case("motion-bounds/curvature", 500, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    if (c.motion.straight()) {
      return;
    }
    constexpr long double kStep = 1e-4L;
    const double t = rng.below(3) == 0 ? 1e-4 : rng.uniform(1e-3, 0.999);
    const Curvature curvature = c.law.curvature(t - 1e-4, t + 1e-4);
    for (const Vec3& v : c.mover.mesh().vertices) {
      const Far3 before = place_by_law(c.motion, v, t - kStep);
      const Far3 here = place_by_law(c.motion, v, t);
      const Far3 after = place_by_law(c.motion, v, t + kStep);
      Far3 bend{};
      for (std::size_t k = 0; k < 3; ++k) {
        bend[k] = (before[k] + after[k] - 2 * here[k]) / (kStep * kStep);
      }
      const double arm = c.law.arm(v);
      ASSERT_LE(distance_from(bend, {}), curvature.of(arm) * (1 + 1e-5) + arm * 1e-9);
    }
  });
}

// All corners lie in the box of the whole body, seen from any side, at any time of a stretch.
TEST(MotionBounds, BoxesHoldTheirPointsAllTheWay) {
  test::for_each_case("motion-bounds/boxes", 500, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const double from = rng.uniform(0, 0.9);
    const MotionInterval interval(c.bounds, from, from + 0.1 * rng.unit());
    const WideTree& tree = c.mover.layout();
    const SweptBoxes box = swept_boxes(tree, tree.nodes()[0], c.bounds, interval, kWholeNode);
    const double s = rng.uniform(-1, 1);
    const Pose pose = c.motion.law_at(interval.middle + s * interval.half);
    for (int side = 0; side < 8; ++side) {
      const Vec3 n = side < 3 ? box.direction[static_cast<std::size_t>(side)]
                              : direction_of({rng.uniform(-1, 1), rng.uniform(-1, 1), 0.1});
      double radius = box.give[0] + c.bounds.box_margin();
      for (std::size_t k = 0; k < 3; ++k) {
        radius += std::abs(dot(n, box.axis[k])) * box.half[k][0];
      }
      for (const Vec3& v : c.mover.mesh().vertices) {
        const Vec3 off = pose.apply(v) - (lane_of(box.center, 0) + lane_of(box.change, 0) * s);
        ASSERT_LE(std::abs(dot(n, off)), radius);
      }
    }
  });
}

bool holds(const TimeWindow& window, double s) {
  return window.lower <= s && s <= window.upper;
}

// Two points, as boxes of no size, that are at one place at one time.
TEST(MotionBounds, WindowsHoldTheTimeOfAMeeting) {
  test::for_each_case("motion-bounds/windows", 1000, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const MotionInterval interval(c.bounds, 0.25, 0.25 + 0x1p-6);
    const double s = rng.uniform(-1, 1);
    const Vec3 v = c.mover.mesh().vertices[rng.below(8)];
    const SweptBoxes x = test::boxes_at(rng, mapped(interval.mean, v), mapped(interval.change, v),
                                        interval.bow.of(c.law.arm(v)));
    const SweptBoxes y =
        test::boxes_at(rng, c.motion.law_at(interval.middle + s * interval.half).apply(v));
    for (const std::string_view name : instruction_sets()) {
      WindowsOfPairs windows;
      motion_kernels(name).meet_nodes(x, y, c.bounds.box_margin(), windows);
      for (std::size_t k = 0; k < 16; ++k) {
        ASSERT_TRUE(windows.has(k / 4, k % 4));
        ASSERT_TRUE(holds(windows.at(k / 4, k % 4), s)) << name;
      }
    }
  });
}

/// Some triangles of the body, as many as lanes have room for or fewer.
std::vector<Triangle> some_triangles(Rng& rng, const MotionCase& c) {
  std::vector<Triangle> triangles;
  for (std::size_t left = 1 + rng.below(TriangleLanes::kLanes); left > 0; --left) {
    triangles.push_back(c.mover.mesh().triangle(static_cast<TriangleId>(rng.below(12))));
  }
  return triangles;
}

/// The bow of any corner.
double bow_of(const MotionCase& c, const MotionInterval& interval,
              const std::vector<Triangle>& triangles) {
  double arm = 0;
  for (const Triangle& t : triangles) {
    for (const Vec3& corner : corners_of(t)) {
      arm = std::max(arm, c.law.arm(corner));
    }
  }
  return interval.bow.of(arm);
}

TEST(MotionBounds, WindowsOfTrianglesHoldTheTimeOfAMeeting) {
  test::for_each_case("motion-bounds/triangles", 1000, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const MotionInterval interval(c.bounds, 0.25, 0.25 + 0x1p-5);
    const double s = rng.uniform(-1, 1);
    const std::vector<Triangle> moving = some_triangles(rng, c);
    const std::size_t lane = rng.below(moving.size());
    const Pose pose = c.motion.law_at(interval.middle + s * interval.half);
    // A triangle that has one corner on a moving one, and goes on somewhere.
    const double share = rng.unit();
    const Vec3 touch = pose.apply(moving[lane].a * (1 - share) + moving[lane].b * share);
    const Vec3 n{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const std::vector<Triangle> resting{{touch, touch + n, touch + cross(n, {1, 2, 3})}};
    for (const std::string_view name : instruction_sets()) {
      const MotionKernels& kernels = motion_kernels(name);
      TriangleLanes x = test::lanes_of(moving);
      TriangleLanes y = test::lanes_of(resting);
      kernels.sweep(interval, bow_of(c, interval, moving), x);
      kernels.place(Pose(), y);
      WindowsOfLanes windows;
      kernels.meet_triangle(x, y, 0, c.bounds.box_margin(), windows);
      ASSERT_NE(windows.open >> lane & 1U, 0U) << name;
      ASSERT_TRUE(holds(windows.at(lane), s)) << name;
    }
  });
}

// A triangle of a leaf touches the corner of a box of no size: both ways around.
TEST(MotionBounds, WindowsOfLeavesHoldTheTimeOfAMeetingWithABox) {
  test::for_each_case("motion-bounds/leaves", 1000, [](Rng& rng) {
    const MotionCase c = any_motion_case(rng);
    const MotionInterval interval(c.bounds, 0.5, 0.5 + 0x1p-6);
    const double s = rng.uniform(-1, 1);
    const Pose pose = c.motion.law_at(interval.middle + s * interval.half);
    const std::vector<Triangle> moving = some_triangles(rng, c);
    const std::size_t lane = rng.below(moving.size());
    const Triangle& t = moving[lane];
    const double share = rng.unit();
    const SweptBoxes still = test::boxes_at(rng, pose.apply(t.b * (1 - share) + t.c * share));
    const SweptBoxes box =
        test::boxes_at(rng, mapped(interval.mean, t.a), mapped(interval.change, t.a),
                       interval.bow.of(c.law.arm(t.a)));
    const Vec3 corner = pose.apply(t.a);
    const Vec3 n{rng.uniform(-9, 9), rng.uniform(-9, 9), rng.uniform(-9, 9)};
    const std::vector<Triangle> resting{{corner, corner + n, corner + cross(n, {3, 2, 1})}};
    for (const std::string_view name : instruction_sets()) {
      const MotionKernels& kernels = motion_kernels(name);
      TriangleLanes x = test::lanes_of(moving);
      kernels.sweep(interval, bow_of(c, interval, moving), x);
      WindowsOfLanes windows;
      kernels.meet_box(x, still, c.bounds.box_margin(), windows);
      ASSERT_NE(windows.open >> lane & 1U, 0U) << name;
      ASSERT_TRUE(holds(windows.at(lane), s)) << name;
      TriangleLanes y = test::lanes_of(resting);
      kernels.place(Pose(), y);
      kernels.meet_box(y, box, c.bounds.box_margin(), windows);
      ASSERT_EQ(windows.open, 1U) << name;
      ASSERT_TRUE(holds(windows.at(0), s)) << name;
    }
  });
}

}  // namespace
}  // namespace soms::detail
