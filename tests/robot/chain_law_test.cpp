// What the proofs of chain_law.h and state_motion.h claim, on chains of joints of all kinds.
#include "soms/robot/detail/chain_law.h"

#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/motion_interval.h"

#include "tests/robot/chains.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace soms::detail {
namespace {

using test::far_apply;
using test::FarPoint;

double distance_from(const FarPoint& a, const Vec3& b) {
  return static_cast<double>(std::hypot(a[0] - b.x, a[1] - b.y, a[2] - b.z));
}

FarPoint far_point(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// A robot between two states, and two of its links, or a link and the cell.
struct ChainCase {
  Robot robot;
  Pose base;
  Kinematics kinematics;
  RobotChains chains;
  std::vector<double> from;
  std::vector<double> to;
  StateMotion motion;
  std::uint32_t link;
  std::optional<std::uint32_t> other;
  Shape mover;
  Shape fixed;
  ChainLaw law;
  MotionBounds bounds;

  ChainCase(Rng& rng, double length, double far)
      : robot(test::random_tree(rng, length)),
        base(Pose::from_axis_angle({1, 2, 3}, rng.uniform(-3, 3), test::random_vector(rng, far))),
        kinematics(robot),
        chains(kinematics, base),
        from(random_state(kinematics, rng)),
        to(test::random_next_state(rng, kinematics, from, length)),
        motion(chains, from, to),
        link(static_cast<std::uint32_t>(rng.below(robot.links.size()))),
        mover(robot.links[link].collisions[0]),
        fixed(robot.links[0].collisions[0]),
        law(make_law(rng)),
        bounds(law, fixed, 0) {}

  ChainLaw make_law(Rng& rng) {
    const auto o = static_cast<std::uint32_t>(rng.below(robot.links.size()));
    if (o == link || rng.below(2) == 0) {
      return ChainLaw(motion, link, mover.bounds(), Pose());
    }
    other = o;
    fixed = Shape(robot.links[o].collisions[0]);
    return ChainLaw(motion, link, mover.bounds(), o, fixed.bounds());
  }

  /// Where the law has a point of the mover in the frame.
  [[nodiscard]] FarPoint place(const Vec3& v, long double t) const {
    const auto poses = test::far_link_poses(kinematics, from, to, base, t);
    const FarPoint in_world = far_apply(poses[link], far_point(v));
    return other ? test::far_back(poses[*other], in_world) : in_world;
  }
};

ChainCase any_chain_case(Rng& rng) {
  constexpr std::array kLengths{1.0, 1.0, 0x1p-40, 1e5};
  const double length = kLengths[rng.below(kLengths.size())];
  return {rng, length, rng.below(3) == 0 ? 1e4 * length : length};
}

TEST(ChainLaw, PosesAreWithinTheSlackOfTheLaw) {
  test::for_each_case("chain-law/slack", 1000, [](Rng& rng) {
    const ChainCase c = any_chain_case(rng);
    const double t = rng.unit();
    const auto poses = test::far_link_poses(c.kinematics, c.from, c.to, c.base, t);
    for (const Vec3& v : c.mover.mesh().vertices) {
      ASSERT_LE(distance_from(c.place(v, t), c.law.at(t).apply(v)), c.law.slack());
      const double off_mover =
          distance_from(far_apply(poses[c.link], far_point(v)), c.law.mover_at(t).apply(v));
      double off_other = 0;
      for (const Vec3& w : c.fixed.mesh().vertices) {
        if (c.other) {
          off_other = std::max(off_other, distance_from(far_apply(poses[*c.other], far_point(w)),
                                                        c.law.other_at(t).apply(w)));
        }
      }
      ASSERT_LE(off_mover + off_other, c.law.slack());
    }
  });
}

// The bound is not only safe, but of the size of what it bounds.
TEST(ChainLaw, PointsAreNearTheChord) {
  double greatest_share = 0;
  test::for_each_case("chain-law/chord", 3000, [&](Rng& rng) {
    const ChainCase c = any_chain_case(rng);
    const double from = rng.below(2) == 0 ? 0 : rng.uniform(0, 0.9);
    const double to = rng.below(2) == 0 ? 1 : rng.uniform(from, 1);
    const MotionInterval interval(c.bounds, from, to);
    for (const Vec3& v : c.mover.mesh().vertices) {
      ASSERT_LE(length_of(turned(interval.change, v)), interval.turn * length_of(v) * kMotionUp);
      const double bound = interval.bow.of(c.law.arm(v)) + 2 * c.law.slack();
      for (const double s : {-0.5, 0.0, rng.uniform(-1, 1)}) {
        const Vec3 chord = mapped(interval.mean, v) + mapped(interval.change, v) * s;
        const double off = distance_from(c.place(v, interval.middle + s * interval.half), chord);
        ASSERT_LE(off, bound);
        greatest_share = std::max(greatest_share, off / bound);
      }
    }
  });
  EXPECT_GT(greatest_share, 0.2);
}

/// A chain of joints that turn about z or slide along x, and the share of the bound that the middle
/// of the way of its end is off the chord by.
double share_of_bound(const std::vector<JointType>& types, const std::vector<double>& from,
                      const std::vector<double>& to) {
  Robot robot{.links = {{.name = "root"}}};
  for (std::uint32_t k = 0; k < types.size(); ++k) {
    robot.links.push_back({.name = std::to_string(k)});
    const bool shifts = types[k] == JointType::prismatic;
    robot.joints.push_back({.name = std::to_string(k),
                            .type = types[k],
                            .parent = k,
                            .child = k + 1,
                            .axis = shifts ? Vec3{1, 0, 0} : Vec3{0, 0, 1}});
  }
  const Kinematics kinematics(robot);
  const RobotChains chains(kinematics, {});
  const StateMotion motion(chains, from, to);
  const auto link = static_cast<std::uint32_t>(types.size());
  const Vec3 v{1e-9, 0, 0};
  const ChainLaw law(motion, link, Box{{}, v}, Pose());
  const auto place = [&](long double t) {
    return far_apply(test::far_link_poses(kinematics, from, to, {}, t)[link], far_point(v));
  };
  const FarPoint first = place(0);
  const FarPoint last = place(1);
  const FarPoint middle = place(0.5);
  const double off = static_cast<double>(std::hypot((first[0] + last[0]) / 2 - middle[0],
                                                    (first[1] + last[1]) / 2 - middle[1],
                                                    (first[2] + last[2]) / 2 - middle[2]));
  const double share = off / (MotionBounds::bow(law.curvature(0, 1).of(law.arm(v)), 1));
  EXPECT_LE(share, 1) << off;
  return share;
}

// Two turns at a time bend more than each does alone; and what slides out while it turns is far
// from the axis at its end, and bends by its speed, too.
TEST(ChainLaw, TurnsOfOneChainBendTogether) {
  using enum JointType;
  EXPECT_GT(share_of_bound({revolute, prismatic}, {0, 0}, {0.02, 0.02}), 0.4);
  EXPECT_GT(share_of_bound({revolute, prismatic}, {0, 5}, {0.02, 5}), 0.4);
  EXPECT_GT(share_of_bound({revolute, revolute, prismatic}, {0, 0, 3}, {0.02, 0.02, 3}), 0.4);
  EXPECT_GT(share_of_bound({revolute, revolute, prismatic}, {0, 0, 0}, {0.02, 0.02, 3}), 0.4);
  EXPECT_GT(share_of_bound({prismatic, revolute}, {0, 0}, {5, 0.02}), 0.1);
}

// An arm that is folded half way has its end on the axis then, and a quarter from it in both
// states.
TEST(ChainLaw, AnEndOnTheAxisHalfWayIsFarFromItBefore) {
  Robot robot{.links = {{.name = "root"}, {.name = "upper"}, {.name = "fore"}, {.name = "end"}}};
  for (std::uint32_t k = 0; k < 3; ++k) {
    robot.joints.push_back({.name = std::to_string(k),
                            .type = k < 2 ? JointType::continuous : JointType::fixed,
                            .parent = k,
                            .child = k + 1,
                            .origin = Pose::translation(k == 0 ? 0 : (k == 1 ? 1 : -1), 0, 0),
                            .axis = {0, 0, 1}});
  }
  const Kinematics kinematics(robot);
  const RobotChains chains(kinematics, {});
  const std::vector<double> from{-10, -0.25};
  const std::vector<double> to{10, 0.25};
  const StateMotion motion(chains, from, to);
  const ChainLaw law(motion, 3, Box{{}, {}}, Pose());
  const auto place = [&](long double t) {
    return far_apply(test::far_link_poses(kinematics, from, to, {}, t)[3], {0, 0, 0});
  };
  constexpr long double kStep = 1e-4L;
  FarPoint bend{};
  for (std::size_t k = 0; k < 3; ++k) {
    bend[k] = (place(0)[k] + place(2 * kStep)[k] - 2 * place(kStep)[k]) / (kStep * kStep);
  }
  const double found = distance_from(bend, {});
  EXPECT_LE(found, law.curvature(0, 1).of(0));
  EXPECT_GT(found, 0.5 * law.curvature(0, 1).of(0));
}

TEST(ChainLaw, VelocitiesAreThoseOfTheCurves) {
  test::for_each_case("chain-law/twist", 300, [](Rng& rng) {
    const ChainCase c(rng, 1, 1);
    const double t = rng.uniform(0.1, 0.9);
    const long double step = 1e-5L;
    const Twist twist = c.law.twist_at(t);
    for (const Vec3& v : c.mover.mesh().vertices) {
      const FarPoint before = c.place(v, t - step);
      const FarPoint after = c.place(v, t + step);
      const Vec3 x = c.law.at(t).apply(v);
      const Vec3 velocity = twist.drift + cross(twist.spin, x - twist.pivot);
      FarPoint quotient{};
      for (std::size_t k = 0; k < 3; ++k) {
        quotient[k] = (after[k] - before[k]) / (2 * step);
      }
      ASSERT_LE(distance_from(quotient, velocity), 1e-6);
    }
  });
}

TEST(ChainLaw, JointsAboveBothLinksCancel) {
  Robot robot{.links = {{.name = "root"}, {.name = "a"}, {.name = "b"}, {.name = "c"}}};
  for (std::uint32_t k = 0; k < 3; ++k) {
    robot.joints.push_back({.name = std::to_string(k),
                            .type = JointType::revolute,
                            .parent = std::min(k, 1U),
                            .child = k + 1,
                            .origin = Pose::translation(1, 0, 0)});
  }
  const Kinematics kinematics(robot);
  const RobotChains chains(kinematics, {});
  const std::vector<double> from{0, 0, 0};
  const std::vector<double> to{1, 0, 0};
  const StateMotion motion(chains, from, to);
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_TRUE(ChainLaw(motion, 2, box, 3, box).rests());
  EXPECT_EQ(ChainLaw(motion, 2, box, 3, box).curvature(0, 1).of(1), 0);
  EXPECT_FALSE(ChainLaw(motion, 2, box, 0, box).rests());
  EXPECT_GT(ChainLaw(motion, 2, box, Pose()).curvature(0, 1).of(1), 0);
}

}  // namespace
}  // namespace soms::detail
