#include "soms/kinematics/kinematics.h"

#include "soms/base/error.h"
#include "soms/base/print.h"
#include "soms/kinematics/print.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace soms {
namespace {

/// A 4x4 matrix that moves column vectors.
using Matrix = std::array<std::array<long double, 4>, 4>;

Matrix unit_matrix() {
  Matrix m{};
  for (std::size_t i = 0; i < 4; ++i) {
    m[i][i] = 1;
  }
  return m;
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        c[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return c;
}

/// Rodrigues' formula: I + sin(q) K + (1 - cos(q)) K K, for the cross product matrix K of an axis.
Matrix rodrigues(const Vec3& axis, long double q) {
  const long double x = axis.x;
  const long double y = axis.y;
  const long double z = axis.z;
  const long double length = std::sqrt(x * x + y * y + z * z);
  const std::array<std::array<long double, 3>, 3> k{
      {{0, -z / length, y / length}, {z / length, 0, -x / length}, {-y / length, x / length, 0}}};
  Matrix m = unit_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      long double square = 0;
      for (std::size_t l = 0; l < 3; ++l) {
        square += k[i][l] * k[l][j];
      }
      m[i][j] += std::sin(q) * k[i][j] + (1 - std::cos(q)) * square;
    }
  }
  return m;
}

Matrix shift_matrix(long double x, long double y, long double z) {
  Matrix m = unit_matrix();
  m[0][3] = x;
  m[1][3] = y;
  m[2][3] = z;
  return m;
}

/// URDF's origin, from its numbers.
struct Origin {
  Vec3 rpy;
  Vec3 xyz;
};

Matrix matrix_of(const Origin& origin) {
  const Matrix turned =
      product(rodrigues({0, 0, 1}, origin.rpy.z),
              product(rodrigues({0, 1, 0}, origin.rpy.y), rodrigues({1, 0, 0}, origin.rpy.x)));
  return product(shift_matrix(origin.xyz.x, origin.xyz.y, origin.xyz.z), turned);
}

Matrix motion_of(const Joint& joint, long double q) {
  if (joint.type == JointType::fixed) {
    return unit_matrix();
  }
  if (joint.type != JointType::prismatic) {
    return rodrigues(joint.axis, q);
  }
  const long double x = joint.axis.x;
  const long double y = joint.axis.y;
  const long double z = joint.axis.z;
  const long double length = std::sqrt(x * x + y * y + z * z);
  return shift_matrix(q * x / length, q * y / length, q * z / length);
}

void expect_near(const Pose& pose, const Matrix& matrix, double most) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      EXPECT_NEAR(pose.m[4 * i + j], static_cast<double>(matrix[i][j]), most) << i << ' ' << j;
    }
  }
}

Vec3 random_vector(Rng& rng, double size) {
  return {rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size)};
}

/// A robot of `n` links, each hung on an earlier one, and the numbers of its origins. Links stand
/// in the list in another order than the tree has them.
Robot random_robot(Rng& rng, std::uint32_t n, std::vector<Origin>& origins) {
  Robot robot{.name = "random"};
  std::vector<std::uint32_t> places(n);  // place in the list of the k-th link of the tree
  for (std::uint32_t k = 0; k < n; ++k) {
    robot.links.push_back({.name = "link" + std::to_string(k)});
    places[k] = k;
  }
  for (std::uint32_t k = n - 1; k > 0; --k) {
    std::swap(places[k], places[rng.below(k + 1)]);
  }
  for (std::uint32_t k = 1; k < n; ++k) {
    origins.push_back({random_vector(rng, 4), random_vector(rng, 1)});
    robot.joints.push_back({.name = "joint" + std::to_string(k),
                            .type = static_cast<JointType>(rng.below(4)),
                            .parent = places[rng.below(k)],
                            .child = places[k],
                            .origin = pose_from_rpy(origins.back().rpy, origins.back().xyz),
                            .axis = random_vector(rng, 3)});
  }
  return robot;
}

/// Where the links are, by matrices, each from its own way to the root.
Matrix matrix_of_link(const Robot& robot, const std::vector<Origin>& origins,
                      const std::vector<double>& values, std::uint32_t link) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (joint.child == link) {
      return product(matrix_of_link(robot, origins, values, joint.parent),
                     product(matrix_of(origins[i]), motion_of(joint, values[i])));
    }
  }
  return unit_matrix();
}

TEST(Kinematics, AgreesWithMatricesOfRodrigues) {
  test::for_each_case("kinematics matrices", 200, [](Rng& rng) {
    std::vector<Origin> origins;
    const Robot robot = random_robot(rng, 2 + static_cast<std::uint32_t>(rng.below(12)), origins);
    const Kinematics kinematics(robot);
    std::vector<double> state(kinematics.size());
    for (double& value : state) {
      value = rng.uniform(-7, 7);
    }
    const std::vector<double> values = kinematics.joint_values(state);
    const std::vector<Pose> poses = link_poses(robot, state);
    for (std::uint32_t link = 0; link < robot.links.size(); ++link) {
      check(poses[link]);
      expect_near(poses[link], matrix_of_link(robot, origins, values, link), 1e-12);
    }
  });
}

TEST(Kinematics, AppliesRollThenPitchThenYaw) {
  test::for_each_case("kinematics rpy", 100, [](Rng& rng) {
    const Origin origin{random_vector(rng, 7), random_vector(rng, 10)};
    expect_near(pose_from_rpy(origin.rpy, origin.xyz), matrix_of(origin), 1e-14);
  });
  EXPECT_EQ(pose_from_rpy({}, {1, 2, 3}), Pose::translation(1, 2, 3));
}

/// A slide along x that carries an arm about z; a finger follows the slide, and one that finger.
Robot small_robot() {
  Robot robot{.name = "small"};
  for (const char* const name : {"base", "slide", "arm", "finger", "tip"}) {
    robot.links.push_back({.name = name});
  }
  robot.joints = {
      {.name = "slides",
       .type = JointType::prismatic,
       .parent = 0,
       .child = 1,
       .axis = {2, 0, 0},
       .lower = 0,
       .upper = 1},
      {.name = "turns",
       .type = JointType::continuous,
       .parent = 1,
       .child = 2,
       .origin = Pose::translation(0, 0, 1),
       .axis = {0, 0, 1}},
      {.name = "closes",
       .type = JointType::prismatic,
       .parent = 2,
       .child = 3,
       .axis = {0, 1, 0},
       .lower = -1,
       .upper = 1,
       .mimic = Mimic{.joint = 0, .multiplier = -1, .offset = 0.5}},
      {.name = "welded", .type = JointType::fixed, .parent = 3, .child = 4},
  };
  return robot;
}

TEST(Kinematics, MovesByLengthAlongTheAxisWhateverItsLength) {
  const std::vector<Pose> poses = link_poses(small_robot(), std::vector<double>{0.25, 0.0});
  EXPECT_EQ(poses[1].shift(), (Vec3{0.25, 0, 0}));
  EXPECT_EQ(poses[2].shift(), (Vec3{0.25, 0, 1}));
  EXPECT_EQ(poses[3].shift(), (Vec3{0.25, 0.25, 1}));  // 0.5 - 0.25
  EXPECT_EQ(poses[4], poses[3]);
  const std::vector<Pose> moved =
      link_poses(small_robot(), std::vector<double>{0.25, 0.0}, Pose::translation(10, 0, 0));
  EXPECT_EQ(moved[1].shift(), (Vec3{10.25, 0, 0}));
}

TEST(Kinematics, FollowsJointsThatFollowOthers) {
  Robot robot = small_robot();
  robot.joints[3].type = JointType::prismatic;
  robot.joints[3].mimic = Mimic{.joint = 2, .multiplier = 4, .offset = 1};
  const Kinematics kinematics(robot);
  EXPECT_EQ(kinematics.movable(), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(kinematics.joint_values(std::vector<double>{0.25, 3}),
            (std::vector<double>{0.25, 3, 0.25, 2}));
}

TEST(Kinematics, SaysWhichJointsAreBeyondTheirLimits) {
  const Kinematics kinematics(small_robot());
  const auto beyond = [&](double slides, double turns) {
    return kinematics.beyond_limits(std::vector<double>{slides, turns});
  };
  using Joints = std::vector<std::uint32_t>;
  EXPECT_EQ(beyond(0, 100), Joints{});
  EXPECT_EQ(beyond(1, 0), Joints{});
  EXPECT_EQ(beyond(std::nextafter(1.0, 2.0), 0), Joints{0});
  EXPECT_EQ(beyond(-1e-300, 0), Joints{0});
  EXPECT_EQ(beyond(1.75, 0), (Joints{0, 2}));  // the finger that follows, too
}

TEST(Kinematics, RefusesStatesThatAreNone) {
  const Kinematics kinematics(small_robot());
  const auto kind = [&](const std::vector<double>& state) {
    try {
      static_cast<void>(kinematics.link_poses(state));
    } catch (const Error& error) {
      return error.kind();
    }
    return ErrorKind::cancelled;
  };
  EXPECT_EQ(kind({1}), ErrorKind::usage);
  EXPECT_EQ(kind({1, 2, 3}), ErrorKind::usage);
  EXPECT_EQ(kind({1, std::numeric_limits<double>::quiet_NaN()}), ErrorKind::not_finite);
  EXPECT_EQ(kind({std::numeric_limits<double>::infinity(), 0}), ErrorKind::not_finite);
}

TEST(Kinematics, GoesStraightFromStateToState) {
  const std::vector<double> from{0.1, -3};
  const std::vector<double> to{0.45, 5};
  EXPECT_EQ(state_between(from, to, 0), from);
  EXPECT_EQ(state_between(from, to, 1), to);  // not 0.1 + (0.45 - 0.1), which is rounded
  EXPECT_EQ(state_between(from, to, 0.25), (std::vector<double>{0.1 + 0.25 * (0.45 - 0.1), -1}));
}

TEST(Kinematics, ListsJointsOfParentsFirst) {
  Robot robot{.links = {{.name = "a"}, {.name = "b"}, {.name = "c"}}};
  robot.joints = {{.name = "low", .parent = 1, .child = 0},
                  {.name = "top", .parent = 2, .child = 1}};
  EXPECT_EQ(Kinematics(robot).order(), (std::vector<std::uint32_t>{1, 0}));
}

TEST(Kinematics, DrawsStatesInsideTheLimits) {
  Robot robot = small_robot();
  robot.joints[0].lower = -1e308;
  robot.joints[0].upper = 1e308;
  const Kinematics kinematics(robot);
  Rng rng(7);
  double least = 0;
  double most = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<double> state = random_state(kinematics, rng);
    EXPECT_LE(std::abs(state[0]), 1e308);
    EXPECT_LE(std::abs(state[1]), 3.1415926535897936);
    least = std::min(least, state[1]);
    most = std::max(most, state[1]);
  }
  EXPECT_LT(least, -3);
  EXPECT_GT(most, 3);
}

}  // namespace
}  // namespace soms
