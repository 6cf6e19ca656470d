/// \file
/// How all joints of a robot go from one state to the next, and how exactly numbers follow them.
///
/// The law. In real numbers, joint j has the value a + t (b - a), where a and b are the doubles of
/// `Kinematics::joint_values` for both states; of a mimic joint, too. A revolute joint turns by
/// this angle about its axis, a prismatic one shifts along it. A link is at the product of `base`
/// and, for each joint down to it, of its origin and this motion. Origins and base are the affine
/// maps that their doubles make. Poses that are decided are `Kinematics::link_poses` of
/// `state_between`, whose sines and cosines are taken to be off by 4 u at most, u = 2^-53. (The C
/// library of GNU promises less than 2 u.)
///
/// Values. A state between is off by 3 u (|a| + |b|): a difference, a product and a sum are
/// rounded. A mimic joint, m x + o, is off by |m| times what x is off, and 2 u (|m x| + |o|) for
/// its own rounding, and as much again at both ends. `off_value` is 4 times this.
///
/// Rotations. The axis, scaled to length 1 twice, has a relative error of 8 u in each coordinate.
/// With the sine and cosine the quaternion is off by 16 u in length, so the rotation is off by 16 u
/// 2 sqrt(2) = 46 u in the Frobenius norm, and its entries by 17 u and 8 u more: 36 u together.
/// Products with it and the origin add 10 u each, as an entry of a product of three is off by 3.01
/// u. So each joint adds 102 u, and what its value is off, to what the matrix of a link is off. If
/// these add up to f, f is at most `turn`: 2^-43 = 1024 u for each joint and the base, and the
/// values.
///
/// Shifts. G is the sum of lengths: of the base's shift, the origins' and the greatest prismatic
/// values. With |a| of a point of the link, no length on the way exceeds G + |a|, but for the
/// stretch of origins that are no rotations. `apply` is off by 4.01 u along an axis, 8 u (G + |a|)
/// in length. So the shift of a link is off by f G, 16 u G for both products of each joint, and
/// what prismatic values are off, with 4 u of them for their axis. `Pose::apply` adds 8 u (G +
/// |a|). All is below (f + 28 u n) (G + |a|) and what prismatic values are off, for n joints and
/// the base. With 1024 u in place of 102 u + 28 u, `slack` is 4 times that and more.
///
/// Stretch. A factor for each pose that is a factor covers what it may do to lengths. It also has
/// 2^-44 for each joint, for the rounding of sums of lengths.
///
/// Underflow. An entry up to 1 is off by 2^-1075 more where it underflows, which the share of 1024
/// u covers; each joint has some 2^6 products of an entry and a length: 2^-1060 for each.
#pragma once

#include "soms/robot/detail/robot_chains.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// The joints of a robot between two states, t from 0 to 1. For one thread.
class StateMotion {
 public:
  /// What of a link's way from the root bounds where it is.
  struct Reach {
    double length = 0;     ///< G
    double stretch = 1;    ///< of all poses that are factors
    double turn = 0;       ///< f: what its matrix is off the law by
    double off_shift = 0;  ///< what prismatic values are off by
    double off = 0;        ///< what its matrix may be off a rotation by, but for `turn`
    double joints = 1;     ///< and the base
  };

  /// Refers to all.
  /// \errors ErrorKind::out_of_range where a joint turns by more than 2^20 radians, or has an angle
  ///         beyond 2^40; as `Kinematics::joint_values`.
  StateMotion(const RobotChains& chains, std::span<const double> from, std::span<const double> to);

  [[nodiscard]] const RobotChains& chains() const { return *chains_; }

  /// How fast the value of a joint changes.
  [[nodiscard]] double rate(std::uint32_t joint) const { return rates_[joint]; }

  /// The greatest prismatic value on the way; of other joints 0.
  [[nodiscard]] double extension(std::uint32_t joint) const { return extensions_[joint]; }

  [[nodiscard]] const Reach& reach(std::uint32_t link) const { return reaches_[link]; }

  /// The pose that is decided of a link.
  [[nodiscard]] Pose pose(std::uint32_t link, double t) const;

 private:
  /// Poses of all links at a time; several pairs of bodies need the same ones.
  struct Known {
    double t = -1;
    std::vector<Pose> poses;
  };

  void look_at_values(std::span<const double> from, std::span<const double> to);
  void look_at_links();

  const RobotChains* chains_;
  std::span<const double> from_;
  std::span<const double> to_;
  std::vector<double> rates_;
  std::vector<double> extensions_;
  std::vector<double> off_values_;
  std::vector<Reach> reaches_;
  mutable std::array<Known, 64> known_;
};

/// A factor of 1 + this covers the rounding of what a joint adds to sums of lengths.
inline constexpr double kLengthMargin = 0x1p-44;

/// Whether a joint turns its link.
[[nodiscard]] bool turns(const Joint& joint);

}  // namespace soms::detail
