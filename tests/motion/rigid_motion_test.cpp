// Motions from one pose to another: what their poses are, and what is refused.
#include "soms/motion/rigid_motion.h"

#include "soms/base/error.h"
#include "soms/motion/print_motion.h"
#include "soms/scene/motion_path.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace soms {
namespace {

constexpr double kNoPlace = std::numeric_limits<double>::quiet_NaN();

template <class Make>
ErrorKind kind_of_motion(const Make& make) {
  try {
    static_cast<void>(make());
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was refused";
  return ErrorKind::usage;
}

Pose any_motion_pose(Rng& rng) {
  return Pose::from_axis_angle({rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(0.1, 1)},
                               rng.uniform(-3, 3),
                               {rng.uniform(-5, 5), rng.uniform(-5, 5), rng.uniform(-5, 5)});
}

void expect_place(const Vec3& a, const Vec3& b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

TEST(RigidMotion, RestsByDefault) {
  const RigidMotion motion;
  EXPECT_EQ(motion.pose_at(0), Pose());
  EXPECT_EQ(motion.pose_at(0.25), Pose());
  EXPECT_EQ(motion.pose_at(1), Pose());
}

TEST(RigidMotion, FollowsTheLawOfPathsBitByBit) {
  test::for_each_case("rigid-motion/law", 200, [](Rng& rng) {
    const Pose a = any_motion_pose(rng);
    const Pose b = any_motion_pose(rng);
    const Vec3 pivot{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
    const RigidMotion motion = RigidMotion::between(a, b, pivot);
    const MotionPath path = motion_path({a, b}, pivot);
    for (const double t : {0.0, 0.125, rng.unit(), 0.875, 1.0}) {
      ASSERT_EQ(motion.pose_at(t), pose_at(path, 0, t));
    }
  });
}

TEST(RigidMotion, AlongKeepsTheRotationBitByBit) {
  Pose start = Pose::about_z(0.3, {1, 2, 3});
  start.m[0] += 1e-8;  // not a rotation to the last bit
  const RigidMotion motion = RigidMotion::along(start, {4, -8, 0.5});
  for (const double t : {0.0, 0.25, 1.0}) {
    const Pose pose = motion.pose_at(t);
    for (std::size_t k = 0; k < 12; ++k) {
      if (k % 4 != 3) {
        EXPECT_EQ(pose.m[k], start.m[k]);
      }
    }
    EXPECT_EQ(pose.shift(), (Vec3{1 + 4 * t, 2 - 8 * t, 3 + 0.5 * t}));
  }
  EXPECT_TRUE(motion.straight());
  EXPECT_EQ(motion.by(), (Vec3{4, -8, 0.5}));
}

TEST(RigidMotion, ATurnKeepsItsCenterAndReachesItsAngle) {
  const Pose start = Pose::about_z(-0.4, {3, 1, 0});
  const Vec3 center{5, 7, -1};
  const RigidMotion motion = RigidMotion::turn(start, center, {0, 0, 2}, 1.2);
  const Vec3 pivot = start.inverse().apply(center);
  for (const double t : {0.0, 0.3, 0.5, 1.0}) {
    expect_place(motion.pose_at(t).apply(pivot), center, 1e-14);
  }
  const Vec3 from = start.apply({0, 0, 0}) - center;
  const Vec3 to = motion.end().apply({0, 0, 0}) - center;
  EXPECT_NEAR(std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y), 1.2, 1e-14);
  const Vec3 middle = motion.pose_at(0.5).apply({0, 0, 0}) - center;
  EXPECT_NEAR(
      std::atan2(from.x * middle.y - from.y * middle.x, from.x * middle.x + from.y * middle.y), 0.6,
      1e-14);
}

TEST(RigidMotion, RefusesWhatIsNoMotion) {
  Pose scaled;
  scaled.m[0] = 2;
  const Pose here;
  EXPECT_EQ(kind_of_motion([&] { return RigidMotion::between(scaled, here); }),
            ErrorKind::not_rigid);
  EXPECT_EQ(kind_of_motion([&] { return RigidMotion::between(here, scaled); }),
            ErrorKind::not_rigid);
  EXPECT_EQ(kind_of_motion([&] {
              return RigidMotion::between(here, here, {kNoPlace, 0, 0});
            }),
            ErrorKind::not_finite);
  EXPECT_EQ(kind_of_motion([&] { return RigidMotion::along(scaled, {}); }), ErrorKind::not_rigid);
  EXPECT_EQ(kind_of_motion([&] {
              return RigidMotion::along(here, {0, kNoPlace, 0});
            }),
            ErrorKind::not_finite);
  EXPECT_EQ(kind_of_motion([&] {
              return RigidMotion::turn(here, {}, {0, 0, 1}, std::numbers::pi);
            }),
            ErrorKind::usage);
  EXPECT_EQ(kind_of_motion([&] {
              return RigidMotion::turn(here, {}, {0, 0, 1}, kNoPlace);
            }),
            ErrorKind::usage);
  EXPECT_EQ(kind_of_motion([&] { return RigidMotion::turn(here, {}, {}, 1); }), ErrorKind::usage);
}

TEST(RigidMotion, IsPrinted) {
  std::ostringstream out;
  out << RigidMotion::along(Pose(), {1, 0, 0});
  EXPECT_EQ(out.str().substr(0, 21), "RigidMotion{straight,");
}

}  // namespace
}  // namespace soms
