#include "soms/kinematics/kinematics.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/base/text.h"

#include <algorithm>
#include <cmath>

namespace soms {

namespace {

/// An axis of length 1; scaled by a power of two first, so that no square overflows.
Vec3 direction_of(const Vec3& axis) {
  const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  const int exponent = std::ilogb(largest);
  const Vec3 u{std::scalbn(axis.x, -exponent), std::scalbn(axis.y, -exponent),
               std::scalbn(axis.z, -exponent)};
  const double length = std::sqrt((u.x * u.x + u.y * u.y) + u.z * u.z);
  return {u.x / length, u.y / length, u.z / length};
}

/// Joints, those of a parent link before those of its children.
std::vector<std::uint32_t> parents_first(const Robot& robot, std::uint32_t root) {
  std::vector<std::vector<std::uint32_t>> below(robot.links.size());
  for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
    below[robot.joints[i].parent].push_back(i);
  }
  std::vector<std::uint32_t> order = below[root];
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::vector<std::uint32_t>& next = below[robot.joints[order[k]].child];
    order.insert(order.end(), next.begin(), next.end());
  }
  return order;
}

/// Joints that mimic, those that they follow first. Each joint is passed once.
std::vector<std::uint32_t> followed_first(const std::vector<Joint>& joints) {
  std::vector<std::uint8_t> is_listed(joints.size(), 0);
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> way;
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    way.clear();
    for (std::uint32_t at = i; joints[at].mimic && is_listed[at] == 0;
         at = joints[at].mimic->joint) {
      is_listed[at] = 1;
      way.push_back(at);
    }
    order.insert(order.end(), way.rbegin(), way.rend());
  }
  return order;
}

}  // namespace

Kinematics::Kinematics(const Robot& robot) : joints_(robot.joints), links_(robot.links.size()) {
  check(robot);
  const PlainArithmetic plain;
  std::vector<std::uint8_t> has_parent(links_, 0);
  for (std::uint32_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    has_parent[joint.child] = 1;
    directions_.push_back(joint.type == JointType::fixed ? Vec3{} : direction_of(joint.axis));
    if (joint.type != JointType::fixed && !joint.mimic) {
      movable_.push_back(i);
    }
  }
  root_ = static_cast<std::uint32_t>(std::find(has_parent.begin(), has_parent.end(), 0) -
                                     has_parent.begin());
  order_ = parents_first(robot, root_);
  mimics_ = followed_first(joints_);
}

std::vector<double> Kinematics::joint_values(std::span<const double> state) const {
  const PlainArithmetic plain;
  if (state.size() != size()) {
    throw Error(ErrorKind::usage,
                "a state of " + std::to_string(state.size()) + " values, but " +
                    std::to_string(size()) + " joints move by themselves",
                "give one value for each of them");
  }
  std::vector<double> values(joints_.size(), 0.0);
  for (std::size_t k = 0; k < state.size(); ++k) {
    values[movable_[k]] = state[k];
  }
  for (const std::uint32_t i : mimics_) {
    const Mimic& mimic = *joints_[i].mimic;
    values[i] = mimic.multiplier * values[mimic.joint] + mimic.offset;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw Error(ErrorKind::not_finite,
                  "the value of joint " + quoted_text(joints_[i].name) + " is not finite",
                  "give finite values");
    }
  }
  return values;
}

std::vector<Pose> Kinematics::link_poses(std::span<const double> state, const Pose& base) const {
  const PlainArithmetic plain;
  const std::vector<double> values = joint_values(state);
  std::vector<Pose> poses(links_);
  poses[root_] = base;
  for (const std::uint32_t i : order_) {
    const Joint& joint = joints_[i];
    const Pose at = poses[joint.parent] * joint.origin;
    const Vec3& u = directions_[i];
    switch (joint.type) {
      case JointType::fixed:
        poses[joint.child] = at;
        break;
      case JointType::revolute:
      case JointType::continuous:
        poses[joint.child] = at * Pose::from_axis_angle(u, values[i]);
        break;
      case JointType::prismatic:
        poses[joint.child] =
            at * Pose::translation(values[i] * u.x, values[i] * u.y, values[i] * u.z);
        break;
    }
  }
  return poses;
}

std::vector<std::uint32_t> Kinematics::beyond_limits(std::span<const double> state) const {
  const std::vector<double> values = joint_values(state);
  std::vector<std::uint32_t> beyond;
  for (std::uint32_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    if (joint.type != JointType::fixed && !(joint.lower <= values[i] && values[i] <= joint.upper)) {
      beyond.push_back(i);
    }
  }
  return beyond;
}

std::vector<double> state_between(std::span<const double> from, std::span<const double> to,
                                  double t) {
  const PlainArithmetic plain;
  std::vector<double> state(from.begin(), from.end());
  for (std::size_t k = 0; k < state.size() && t != 0; ++k) {
    state[k] = t == 1 ? to[k] : from[k] + t * (to[k] - from[k]);
  }
  return state;
}

std::vector<double> random_state(const Kinematics& kinematics, Rng& rng) {
  constexpr double kPi = 3.14159265358979323846;
  const PlainArithmetic plain;
  std::vector<double> state;
  for (const std::uint32_t i : kinematics.movable()) {
    const Joint& joint = kinematics.joints()[i];
    const double lower = std::isinf(joint.lower) ? std::min(-kPi, joint.upper) : joint.lower;
    const double upper = std::isinf(joint.upper) ? std::max(kPi, joint.lower) : joint.upper;
    const double share = rng.unit();
    // Not lower + (upper - lower) * share, which may overflow; the sum may round beyond a limit.
    state.push_back(std::clamp(lower * (1 - share) + upper * share, lower, upper));
  }
  return state;
}

std::vector<Pose> link_poses(const Robot& robot, std::span<const double> state, const Pose& base) {
  return Kinematics(robot).link_poses(state, base);
}

}  // namespace soms
