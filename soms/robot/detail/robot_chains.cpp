#include "soms/robot/detail/robot_chains.h"

#include "soms/motion/detail/motion_law.h"
#include "soms/motion/detail/quaternion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

/// Covers what rounding adds to a measured norm, 4 u for each of 9 entries, ten times.
constexpr double kNormMargin = 0x1p-45;

/// The Frobenius norm of R^T R - I.
double off_orthonormal(const Pose& pose) {
  const auto& m = pose.m;
  double squares = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry =
          ((m[i] * m[j] + m[4 + i] * m[4 + j]) + m[8 + i] * m[8 + j]) - (i == j ? 1.0 : 0.0);
      squares += entry * entry;
    }
  }
  return std::sqrt(squares) * kMotionUp + kNormMargin;
}

}  // namespace

/// With s a singular value, |s - 1| <= |s^2 - 1|, whose norm over all three is `off`. So the matrix
/// is off the nearest rotation by `off`, and 1 / s <= 1 + 2 off as `off` is below 1e-5.
PoseLengths::PoseLengths(const Pose& pose)
    : shift(length_of(pose.shift()) * kMotionUp), off(off_orthonormal(pose)) {
  stretch = 1 + 2 * off;
}

RobotChains::RobotChains(const Kinematics& kinematics, const Pose& base)
    : kinematics_(&kinematics), base_(base), base_lengths_(base) {
  const std::vector<Joint>& joints = kinematics.joints();
  above_.assign(joints.size() + 1, kNone);
  depth_.assign(joints.size() + 1, 0);
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    lengths_.push_back(PoseLengths(joints[i].origin));
    above_[joints[i].child] = i;
  }
  for (const std::uint32_t i : kinematics.order()) {
    depth_[joints[i].child] = depth_[joints[i].parent] + 1;
  }
}

std::vector<ChainStep> RobotChains::between(std::uint32_t from, std::uint32_t to) const {
  const std::vector<Joint>& joints = kinematics_->joints();
  std::vector<ChainStep> up;
  std::vector<ChainStep> down;
  while (from != to) {
    const bool climbs = depth_[from] >= depth_[to];
    std::uint32_t& link = climbs ? from : to;
    (climbs ? up : down).push_back({above_[link], climbs});
    link = joints[above_[link]].parent;
  }
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

}  // namespace soms::detail
