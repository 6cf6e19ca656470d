/// \file
/// Chains of joints for tests of ways between states, and where they put points by long doubles.
#pragma once

#include "soms/base/random.h"
#include "soms/kinematics/kinematics.h"

#include "tests/support/bodies.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace soms::test {

[[nodiscard]] inline Vec3 random_vector(Rng& rng, double most) {
  return {rng.uniform(-most, most), rng.uniform(-most, most), rng.uniform(-most, most)};
}

/// A long thin box along one axis.
[[nodiscard]] inline Mesh beam(Rng& rng, double length) {
  Vec3 half{0.05, 0.05, 0.05};
  half[rng.below(3)] = 0.5;
  const Vec3 middle = random_vector(rng, 0.3);
  return box_body((middle - half) * length, (middle + half) * length);
}

/// A tree of beams. Its joints turn, shift, mimic each other, or are fixed; links hang from any
/// link before, as a rule from the last one.
[[nodiscard]] inline Robot random_tree(Rng& rng, double length) {
  Robot robot{.name = "tree"};
  const auto links = static_cast<std::uint32_t>(2 + rng.below(5));
  for (std::uint32_t k = 0; k < links; ++k) {
    robot.links.push_back({.name = std::to_string(k), .collisions = {beam(rng, length)}});
    if (k == 0) {
      continue;
    }
    constexpr std::array kTypes{JointType::revolute, JointType::continuous, JointType::prismatic,
                                JointType::revolute, JointType::fixed};
    Joint joint{.name = std::to_string(k),
                .type = kTypes[rng.below(kTypes.size())],
                .parent = rng.below(4) == 0 ? static_cast<std::uint32_t>(rng.below(k)) : k - 1,
                .child = k,
                .origin = Pose::from_axis_angle(random_vector(rng, 1) + Vec3{0, 0, 2},
                                                rng.uniform(-3, 3), random_vector(rng, length)),
                .axis = random_vector(rng, 2) + Vec3{0, 0, 0.1}};
    if (rng.below(4) == 0) {
      joint.origin.m[0] *= 1 + 1e-7;  // off a rotation, as files have it
    }
    if (k > 1 && rng.below(5) == 0 && joint.type != JointType::fixed &&
        robot.joints[k - 2].type != JointType::fixed) {
      joint.mimic = Mimic{.joint = k - 2, .multiplier = rng.uniform(-1, 1), .offset = 0.1};
    }
    robot.joints.push_back(std::move(joint));
  }
  return robot;
}

/// A state next to `from`, or far from it.
[[nodiscard]] inline std::vector<double> random_next_state(Rng& rng, const Kinematics& kinematics,
                                                           const std::vector<double>& from,
                                                           double length) {
  constexpr std::array kSteps{2.0, 0.3, 1e-3};
  const double step = kSteps[rng.below(kSteps.size())];
  std::vector<double> to = from;
  for (std::size_t k = 0; k < to.size(); ++k) {
    const bool shifts = kinematics.joints()[kinematics.movable()[k]].type == JointType::prismatic;
    to[k] += rng.below(4) == 0 ? 0 : rng.uniform(-step, step) * (shifts ? length : 1);
  }
  return to;
}

/// Rows of a 3 x 4 matrix.
using FarPose = std::array<std::array<long double, 4>, 3>;
using FarPoint = std::array<long double, 3>;

[[nodiscard]] inline FarPose far_pose(const Pose& pose) {
  FarPose far{};
  for (std::size_t k = 0; k < 12; ++k) {
    far[k / 4][k % 4] = pose.m[k];
  }
  return far;
}

[[nodiscard]] inline FarPoint far_apply(const FarPose& a, const FarPoint& v) {
  FarPoint moved{};
  for (std::size_t i = 0; i < 3; ++i) {
    moved[i] = a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2] + a[i][3];
  }
  return moved;
}

[[nodiscard]] inline FarPose operator*(const FarPose& a, const FarPose& b) {
  FarPose product{};
  for (std::size_t j = 0; j < 4; ++j) {
    const FarPoint column = far_apply(a, {b[0][j], b[1][j], b[2][j]});
    for (std::size_t i = 0; i < 3; ++i) {
      product[i][j] = column[i] - (j < 3 ? a[i][3] : 0);
    }
  }
  return product;
}

/// The point that an affine map takes to `v`.
[[nodiscard]] inline FarPoint far_back(const FarPose& a, const FarPoint& v) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t r, std::size_t c) { return a[(i + r) % 3][(j + c) % 3]; };
    return at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
  };
  const long double det = a[0][0] * minor(0, 0) + a[0][1] * minor(0, 1) + a[0][2] * minor(0, 2);
  FarPoint back{};
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 3; ++i) {
      back[j] += minor(i, j) / det * (v[i] - a[i][3]);
    }
  }
  return back;
}

/// The motion of a joint at a value.
[[nodiscard]] inline FarPose far_motion(const Joint& joint, long double value) {
  const long double length =
      std::hypot(static_cast<long double>(joint.axis.x), joint.axis.y, joint.axis.z);
  const FarPoint u{joint.axis.x / length, joint.axis.y / length, joint.axis.z / length};
  FarPose far = far_pose(Pose());
  if (joint.type == JointType::prismatic) {
    for (std::size_t i = 0; i < 3; ++i) {
      far[i][3] = value * u[i];
    }
  } else if (joint.type != JointType::fixed) {
    const long double c = std::cos(value);
    const long double s = std::sin(value);
    const FarPose across{{{0, -u[2], u[1], 0}, {u[2], 0, -u[0], 0}, {-u[1], u[0], 0, 0}}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        far[i][j] = (i == j ? c : 0) + s * across[i][j] + (1 - c) * u[i] * u[j];
      }
    }
  }
  return far;
}

/// Poses of all links in real numbers, as far as long doubles go, at a part `t` of the way.
[[nodiscard]] inline std::vector<FarPose> far_link_poses(const Kinematics& kinematics,
                                                         const std::vector<double>& from,
                                                         const std::vector<double>& to,
                                                         const Pose& base, long double t) {
  const std::vector<double> first = kinematics.joint_values(from);
  const std::vector<double> last = kinematics.joint_values(to);
  std::vector<FarPose> poses(kinematics.joints().size() + 1);
  poses[kinematics.root()] = far_pose(base);
  for (const std::uint32_t i : kinematics.order()) {
    const Joint& joint = kinematics.joints()[i];
    const long double value = first[i] + t * (static_cast<long double>(last[i]) - first[i]);
    poses[joint.child] = poses[joint.parent] * far_pose(joint.origin) * far_motion(joint, value);
  }
  return poses;
}

}  // namespace soms::test
