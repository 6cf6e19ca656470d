/// \file
/// Where are the links of a robot when its joints have given values? Forward kinematics.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/kinematics/robot.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace soms {

/// The joints of a robot in an order in which poses can be computed. A value; it keeps no meshes.
///
/// A state is one number for each movable joint: those that are neither fixed nor mimic, in the
/// order of Robot::joints. Radians, or the robot's unit of length.
class Kinematics {
 public:
  /// \errors As `check(Robot)`.
  explicit Kinematics(const Robot& robot);

  /// Numbers a state has.
  [[nodiscard]] std::size_t size() const { return movable_.size(); }

  /// The joints whose values make a state.
  [[nodiscard]] const std::vector<std::uint32_t>& movable() const { return movable_; }

  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }

  /// All joints, those of a parent link before those of its children.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  /// The link without a parent.
  [[nodiscard]] std::uint32_t root() const { return root_; }

  /// The value of each joint, in the order of Robot::joints; of fixed ones 0.
  /// \shape  `state`: size().
  /// \errors ErrorKind::usage for another number of values; not_finite, which names the joint.
  [[nodiscard]] std::vector<double> joint_values(std::span<const double> state) const;

  /// The pose of each link, in the order of Robot::links, with the root at `base`: of a child
  /// `(parent * origin) * motion`, where `motion` is `Pose::from_axis_angle(axis, value)`, or a
  /// shift by `value * (axis / |axis|)`.
  ///
  /// These are rounded poses, with sines and cosines of the C library, whose last bits differ
  /// between platforms. Queries about bodies at these poses are exact for the poses as they are.
  /// \errors As `joint_values`.
  /// \cost   O(n) for n links, about 0.2 us a joint.
  [[nodiscard]] std::vector<Pose> link_poses(std::span<const double> state,
                                             const Pose& base = {}) const;

  /// Joints whose values are outside of their limits, mimic ones too, ascending.
  /// \errors As `joint_values`.
  [[nodiscard]] std::vector<std::uint32_t> beyond_limits(std::span<const double> state) const;

 private:
  std::vector<Joint> joints_;
  std::vector<Vec3> directions_;        ///< axes of length 1
  std::vector<std::uint32_t> movable_;  ///< joints
  std::vector<std::uint32_t> order_;    ///< joints, parents first
  std::vector<std::uint32_t> mimics_;   ///< joints that mimic, those that they follow first
  std::size_t links_ = 0;
  std::uint32_t root_ = 0;
};

/// The poses of all links: `Kinematics(robot).link_poses(state, base)`, for callers who ask once.
/// \errors As `Kinematics`.
[[nodiscard]] std::vector<Pose> link_poses(const Robot& robot, std::span<const double> state,
                                           const Pose& base = {});

/// The state at a part `t` of the way between two: of each value `from + t * (to - from)`, each
/// operation rounded once; at 0 and 1 the two as they are. Each value goes straight, so an angle
/// takes the way of its numbers, not the shorter one around.
/// \shape  `from`, `to`: k each, of which k numbers come back.
/// \pre    Both have as many values.
[[nodiscard]] std::vector<double> state_between(std::span<const double> from,
                                                std::span<const double> to, double t);

/// A state inside the limits of the movable joints, uniformly; of a continuous joint, and where a
/// limit is infinite, within pi. The same on every machine.
[[nodiscard]] std::vector<double> random_state(const Kinematics& kinematics, Rng& rng);

}  // namespace soms
