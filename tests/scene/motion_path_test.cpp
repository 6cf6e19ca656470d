#include "soms/scene/motion_path.h"

#include "soms/base/error.h"
#include "soms/scene/detail/motion_segment.h"
#include "soms/scene/reference/clearance_along.h"

#include "tests/scene/random_bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace soms {
namespace {

constexpr double kQuarter = 1.57079632679489661923;

double length(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

/// Any rotation, half turns and nearly none among them.
Pose any_turn(Rng& rng) {
  const Vec3 axis{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  constexpr std::array kAngles{0.0, 1e-9, 1e-4, 0.3, kQuarter, 2.0, 3.0, 2 * kQuarter};
  const double angle = kAngles[rng.below(kAngles.size())];
  return Pose::from_axis_angle(length(axis) > 0.1 ? axis : Vec3{0, 0, 1}, angle);
}

MotionPath any_path(Rng& rng, std::size_t poses, double far) {
  std::vector<Pose> given;
  for (std::size_t k = 0; k < poses; ++k) {
    Pose pose = any_turn(rng);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pose.m[4 * axis + 3] = far + rng.uniform(-3, 3);
    }
    given.push_back(rng.below(4) == 0 && k > 0 ? given.back() * any_turn(rng) : pose);
  }
  return motion_path(given, {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)});
}

TEST(MotionPath, MeasuresTheLineOfThePivot) {
  const std::vector<Pose> poses{Pose::translation(0, 0, 0), Pose::about_z(kQuarter, {3, 4, 0}),
                                Pose::about_z(0, {3, 4, 0})};
  EXPECT_EQ(motion_path(poses).chainage, (std::vector<double>{0, 5, 5}));
  // The pivot (1, 0, 0) goes to (3, 5, 0), then to (4, 4, 0).
  const MotionPath path = motion_path(poses, {1, 0, 0});
  EXPECT_NEAR(path.chainage[1], std::sqrt(29), 1e-12);
  EXPECT_NEAR(path.chainage[2], std::sqrt(29) + std::sqrt(2), 1e-12);
}

TEST(MotionPath, BetweenTwoPosesThePivotIsOnTheLineAndTheTurnIsHalf) {
  const MotionPath path = motion_path({Pose(), Pose::about_z(kQuarter, {2, 0, 0})}, {0, 0, 0});
  const Pose middle = pose_at(path, 0, 0.5);
  const Pose expected = Pose::about_z(kQuarter / 2, {1, 0, 0});
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_NEAR(middle.m[k], expected.m[k], 1e-15);
  }
  EXPECT_EQ(pose_at(path, 0, 0), path.poses[0]);
  EXPECT_EQ(pose_at(path, 0, 1), path.poses[1]);
}

TEST(MotionPath, RefusesWhatIsNoPath) {
  const auto kind_of = [](const MotionPath& path) {
    try {
      check(path);
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  Pose scaled;
  scaled.m[0] = 2;
  EXPECT_EQ(kind_of({}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{Pose()}, {}, {}}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{Pose(), Pose()}, {1, 0}, {}}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{Pose()}, {std::numeric_limits<double>::quiet_NaN()}, {}}), ErrorKind::usage);
  EXPECT_EQ(kind_of({{Pose(), scaled}, {0, 1}, {}}), ErrorKind::not_rigid);
  EXPECT_NO_THROW(check({{Pose()}, {7}, {}}));
}

// The twin takes sines and angles, which `pose_at` does without.
TEST(MotionPath, AgreesWithTheTwinByAngles) {
  test::for_each_case("motion-path/angles", 500, [](Rng& rng) {
    const MotionPath path = any_path(rng, 2, 0);
    const Pose turn = path.poses[0].inverse() * path.poses[1];
    const double cosine = (turn.m[0] + turn.m[5] + turn.m[10] - 1) / 2;
    if (cosine < -0.9999) {
      return;  // of a half turn, either may go the other way
    }
    const double t = rng.unit();
    const Pose pose = pose_at(path, 0, t);
    const Pose twin = reference::pose_by_angle(path, 0, t);
    for (std::size_t k = 0; k < 12; ++k) {
      ASSERT_NEAR(pose.m[k], twin.m[k], 1e-11);
    }
  });
}

// Of any corner of a box: its ways from a to any place between, and on to b, are no longer together
// than the bound, and rounded places are within their slack of those that long double finds.
TEST(MotionPath, NoPointMovesFartherThanItsBound) {
  test::for_each_case("motion-path/bound", 500, [](Rng& rng) {
    constexpr std::array kFar{0.0, 1e3, 1e7};
    const MotionPath path = any_path(rng, 2, kFar[rng.below(kFar.size())]);
    Box box;
    for (int k = 0; k < 2 + static_cast<int>(rng.below(2)); ++k) {
      box.grow(Vec3{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)});
    }
    const detail::MotionSegment motion(path, 0, box);
    const double first = rng.below(3) == 0 ? 0 : rng.uniform(0, 0.5);
    const double last = rng.below(3) == 0 ? 1 : rng.uniform(0.5, 1);
    const detail::MotionPlace a = motion.at(first);
    const detail::MotionPlace b = motion.at(last);
    const double bound = motion.most_motion(a, b);
    const double slack = a.slack + b.slack + 2 * motion.slack();
    for (int n = 0; n < 20; ++n) {
      const double t = rng.uniform(first, last);
      const Pose between = motion.at(t).pose;
      for (int c = 0; c < 8; ++c) {
        const Vec3 corner{(c & 1) != 0 ? box.upper.x : box.lower.x,
                          (c & 2) != 0 ? box.upper.y : box.lower.y,
                          (c & 4) != 0 ? box.upper.z : box.lower.z};
        const Vec3 at = between.apply(corner);
        const double sum = length(at - a.pose.apply(corner)) + length(b.pose.apply(corner) - at);
        ASSERT_LE(sum, bound + slack);
      }
    }
  });
}

// The bound is not only safe, but near what a corner does, or it would cost many places.
TEST(MotionPath, TheBoundOfAShortMotionIsTight) {
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const MotionPath turn = motion_path({Pose(), Pose::about_z(0.01)});
  const detail::MotionSegment motion(turn, 0, box);
  EXPECT_NEAR(motion.most_motion(motion.at(0), motion.at(1)), 0.01 * std::sqrt(2), 1e-6);
  const MotionPath shift = motion_path({Pose(), Pose::translation(0.5, 0, 0)});
  const detail::MotionSegment straight(shift, 0, box);
  EXPECT_NEAR(straight.most_motion(straight.at(0.25), straight.at(0.75)), 0.25, 1e-12);
}

}  // namespace
}  // namespace soms
