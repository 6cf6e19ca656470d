/// \file
/// What of a robot's joints is the same in all states: how they hang together, and their lengths.
#pragma once

#include "soms/base/pose.h"
#include "soms/kinematics/kinematics.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// A joint on the way from one link to another, which it is passed up to its parent or down.
struct ChainStep {
  std::uint32_t joint = 0;
  bool up = false;
};

/// What a pose may do to vectors, as it may be off a rotation by 1e-6.
struct PoseLengths {
  double shift = 0;    ///< at least the length of its shift
  double stretch = 1;  ///< no vector gets longer by more, neither by the pose nor by its inverse
  double off = 0;      ///< at least the Frobenius norm of its matrix less the nearest rotation

  explicit PoseLengths(const Pose& pose);
};

/// The tree of a robot's joints.
class RobotChains {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  /// Refers to `kinematics`.
  RobotChains(const Kinematics& kinematics, const Pose& base);

  [[nodiscard]] const Kinematics& kinematics() const { return *kinematics_; }

  [[nodiscard]] const Pose& base() const { return base_; }

  [[nodiscard]] const PoseLengths& base_lengths() const { return base_lengths_; }

  /// Of the origin of a joint.
  [[nodiscard]] const PoseLengths& lengths(std::uint32_t joint) const { return lengths_[joint]; }

  /// The joint that moves a link; kNone for the root.
  [[nodiscard]] std::uint32_t above(std::uint32_t link) const { return above_[link]; }

  /// The joints between two links: up to the nearest link that both hang from, then down.
  [[nodiscard]] std::vector<ChainStep> between(std::uint32_t from, std::uint32_t to) const;

 private:
  const Kinematics* kinematics_;
  Pose base_;
  PoseLengths base_lengths_;
  std::vector<PoseLengths> lengths_;
  std::vector<std::uint32_t> above_;
  std::vector<std::uint32_t> depth_;  ///< of each link
};

}  // namespace soms::detail
