#include "soms/robot/detail/state_motion.h"

#include "soms/base/error.h"
#include "soms/base/portable.h"
#include "soms/motion/detail/motion_law.h"
#include "soms/motion/detail/rigid_law.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace soms::detail {

namespace {

constexpr double kJointShare = 0x1p-43;
constexpr double kValueShare = 0x1p-49;

static_assert(kJointShare >= 4 * (102 + 28) * kMotionUnit, "rounding of a joint, four times");
static_assert(kValueShare >= 4 * 3 * kMotionUnit, "rounding of a state between, four times");
static_assert(kLengthMargin >= 4 * 16 * kMotionUnit, "rounding of sums of lengths");

constexpr double kMostTurn = 0x1p20;
constexpr double kMostAngle = 0x1p40;

/// What the value of each joint may be off the law by, between two lists of values.
class OffValues {
 public:
  OffValues(const std::vector<Joint>& joints, const std::vector<double>& from,
            const std::vector<double>& to)
      : joints_(joints), from_(from), to_(to) {}

  [[nodiscard]] double of(std::uint32_t joint) const {
    const auto& mimic = joints_[joint].mimic;
    if (!mimic) {
      return kValueShare * size(joint);
    }
    const double factor = std::abs(mimic->multiplier);
    return factor * of(mimic->joint) +
           kValueShare * (factor * size(mimic->joint) + std::abs(mimic->offset));
  }

 private:
  [[nodiscard]] double size(std::uint32_t joint) const {
    return std::abs(from_[joint]) + std::abs(to_[joint]);
  }

  const std::vector<Joint>& joints_;
  const std::vector<double>& from_;
  const std::vector<double>& to_;
};

}  // namespace

bool turns(const Joint& joint) {
  return joint.type == JointType::revolute || joint.type == JointType::continuous;
}

StateMotion::StateMotion(const RobotChains& chains, std::span<const double> from,
                         std::span<const double> to)
    : chains_(&chains), from_(from), to_(to) {
  look_at_values(from, to);
  look_at_links();
}

void StateMotion::look_at_values(std::span<const double> from, std::span<const double> to) {
  const Kinematics& kinematics = chains_->kinematics();
  const std::vector<Joint>& joints = kinematics.joints();
  const std::vector<double> first = kinematics.joint_values(from);
  const std::vector<double> last = kinematics.joint_values(to);
  const OffValues off(joints, first, last);
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    rates_.push_back(last[i] - first[i]);
    const double most = std::max(std::abs(first[i]), std::abs(last[i]));
    extensions_.push_back(joints[i].type == JointType::prismatic ? most : 0.0);
    off_values_.push_back(joints[i].type == JointType::fixed ? 0.0 : off.of(i));
    if (turns(joints[i]) && !(most <= kMostAngle && std::abs(rates_[i]) <= kMostTurn)) {
      throw Error(ErrorKind::out_of_range,
                  "joint " + joints[i].name + " turns by more than 2^20, or up to beyond 2^40",
                  "give states in between, and angles of few turns");
    }
  }
}

void StateMotion::look_at_links() {
  const std::vector<Joint>& joints = chains_->kinematics().joints();
  reaches_.resize(joints.size() + 1);
  const PoseLengths& base = chains_->base_lengths();
  reaches_[chains_->kinematics().root()] = {
      .length = base.shift, .stretch = base.stretch, .turn = kJointShare, .off = base.off};
  for (const std::uint32_t i : chains_->kinematics().order()) {
    const PoseLengths& origin = chains_->lengths(i);
    Reach reach = reaches_[joints[i].parent];
    reach.length += origin.shift + extensions_[i];
    reach.stretch *= origin.stretch + kLengthMargin;
    reach.turn += kJointShare;
    (turns(joints[i]) ? reach.turn : reach.off_shift) += off_values_[i];
    reach.off += origin.off;
    reach.joints += 1;
    reaches_[joints[i].child] = reach;
  }
}

Pose StateMotion::pose(std::uint32_t link, double t) const {
  const auto bits = bit_cast<std::uint64_t>(t);
  Known& known = known_[(bits * 0x9e3779b97f4a7c15U) >> 58U];
  if (known.t != t) {
    known.poses = chains_->kinematics().link_poses(state_between(from_, to_, t), chains_->base());
    known.t = t;
  }
  return known.poses[link];
}

}  // namespace soms::detail
