#include "soms/kinematics/robot.h"

#include "soms/base/arithmetic.h"
#include "soms/base/text.h"

#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>

namespace soms {

namespace {

bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

RobotFault joint_fault(const Robot& robot, std::size_t joint, const std::string& what,
                       std::string remedy, ErrorKind kind = ErrorKind::bad_file) {
  return {.kind = kind,
          .what = "joint " + quoted_text(robot.joints[joint].name) + " " + what,
          .remedy = std::move(remedy),
          .joint = static_cast<std::uint32_t>(joint)};
}

RobotFault link_fault(const Robot& robot, std::size_t link, const std::string& what,
                      std::string remedy) {
  return {.what = "link " + quoted_text(robot.links[link].name) + " " + what,
          .remedy = std::move(remedy),
          .link = static_cast<std::uint32_t>(link)};
}

std::optional<RobotFault> fault_of_names(const Robot& robot) {
  if (robot.links.empty()) {
    return RobotFault{.what = "the robot has no links",
                      .remedy = "give a URDF file with at least one link; an SRDF file has none"};
  }
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name.empty() || !names.insert(robot.links[i].name).second) {
      return link_fault(robot, i,
                        robot.links[i].name.empty() ? "has no name" : "has the name of another",
                        "give each link a name of its own");
    }
  }
  names.clear();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].name.empty() || !names.insert(robot.joints[i].name).second) {
      return joint_fault(robot, i,
                         robot.joints[i].name.empty() ? "has no name" : "has the name of another",
                         "give each joint a name of its own");
    }
  }
  return std::nullopt;
}

/// Faults of the numbers of a joint.
std::optional<RobotFault> fault_of_joint(const Robot& robot, std::size_t i) {
  const Joint& joint = robot.joints[i];
  try {
    check(joint.origin);
  } catch (const Error& error) {
    return joint_fault(robot, i, "has an origin that is no pose: " + error.place(), error.remedy(),
                       error.kind());
  }
  if (joint.type == JointType::fixed) {
    return std::nullopt;
  }
  if (!is_finite(joint.axis)) {
    return joint_fault(robot, i, "has an axis that is not finite", "give three finite numbers",
                       ErrorKind::not_finite);
  }
  if (joint.axis == Vec3{}) {
    return joint_fault(robot, i, "has the axis 0 0 0, which is no direction",
                       "give an axis of any other length, such as 0 0 1");
  }
  if (std::isnan(joint.lower) || std::isnan(joint.upper)) {
    return joint_fault(robot, i, "has a limit that is not a number", "give numbers",
                       ErrorKind::not_finite);
  }
  if (joint.lower > joint.upper) {
    return joint_fault(robot, i,
                       "has the lower limit " + shortest(joint.lower) + " above the upper limit " +
                           shortest(joint.upper),
                       "exchange or correct the limits");
  }
  return std::nullopt;
}

/// Faults of what a joint follows, but for circles.
std::optional<RobotFault> fault_of_mimic(const Robot& robot, std::size_t i) {
  const std::vector<Joint>& joints = robot.joints;
  if (!joints[i].mimic) {
    return std::nullopt;
  }
  const Mimic& mimic = *joints[i].mimic;
  if (joints[i].type == JointType::fixed) {
    return joint_fault(robot, i, "is fixed and mimics another", "drop one of both");
  }
  if (!std::isfinite(mimic.multiplier) || !std::isfinite(mimic.offset)) {
    return joint_fault(robot, i, "mimics by a number that is not finite", "give finite numbers",
                       ErrorKind::not_finite);
  }
  if (mimic.joint >= joints.size()) {
    return joint_fault(robot, i, "mimics a joint that does not exist", "name one that exists",
                       ErrorKind::out_of_range);
  }
  if (joints[mimic.joint].type == JointType::fixed) {
    return joint_fault(robot, i,
                       "mimics " + quoted_text(joints[mimic.joint].name) + ", which is fixed",
                       "make it fixed, too");
  }
  return std::nullopt;
}

/// Joints that mimic each other in a circle. Each joint is passed once.
/// \pre No other fault of mimic joints.
std::optional<RobotFault> fault_of_mimic_circles(const Robot& robot) {
  std::vector<std::size_t> first(robot.joints.size(), robot.joints.size());  // that came by
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    std::size_t at = i;
    while (robot.joints[at].mimic && first[at] == robot.joints.size()) {
      first[at] = i;
      at = robot.joints[at].mimic->joint;
    }
    if (robot.joints[at].mimic && first[at] == i) {
      return joint_fault(robot, at, "mimics itself, or joints that mimic each other in a circle",
                         "let one of them move by itself");
    }
  }
  return std::nullopt;
}

/// Faults of the tree.
std::optional<RobotFault> fault_of_tree(const Robot& robot) {
  constexpr std::uint32_t kNone = 0xffffffffU;
  std::vector<std::uint32_t> above(robot.links.size(), kNone);  // parent of each link
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const Joint& joint = robot.joints[i];
    if (joint.parent >= robot.links.size() || joint.child >= robot.links.size()) {
      return joint_fault(robot, i, "connects a link that does not exist", "name links that exist",
                         ErrorKind::out_of_range);
    }
    if (joint.parent == joint.child) {
      return joint_fault(robot, i, "connects a link to itself", "name two links");
    }
    if (above[joint.child] != kNone) {
      return joint_fault(
          robot, i, "gives link " + quoted_text(robot.links[joint.child].name) + " a second parent",
          "let one joint alone have it as its child");
    }
    above[joint.child] = joint.parent;
  }
  std::optional<std::size_t> root;
  for (std::size_t link = 0; link < above.size(); ++link) {
    if (above[link] != kNone) {
      continue;
    }
    if (root) {
      return link_fault(robot, link,
                        "has no parent, nor has " + quoted_text(robot.links[*root].name),
                        "connect all links to one root by joints");
    }
    root = link;
  }
  if (!root || robot.joints.size() + 1 != robot.links.size()) {
    return RobotFault{.what = "the links have no root: joints connect them in a circle",
                      .remedy = "drop the joint that closes the circle",
                      .joint = 0};
  }
  // One root, and a parent for each other link. A circle would be apart from the root.
  std::vector<std::uint8_t> reaches(above.size(), 0);
  reaches[*root] = 1;
  for (std::size_t link = 0; link < above.size(); ++link) {
    std::vector<std::size_t> way;
    std::size_t at = link;
    for (; reaches[at] == 0 && way.size() <= above.size(); at = above[at]) {
      way.push_back(at);
    }
    if (way.size() > above.size()) {
      return link_fault(robot, link, "is part of, or hangs on, a circle of joints",
                        "drop the joint that closes the circle");
    }
    for (const std::size_t passed : way) {
      reaches[passed] = 1;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<RobotFault> find_fault(const Robot& robot) {
  const PlainArithmetic plain;
  if (auto fault = fault_of_names(robot)) {
    return fault;
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (auto fault = fault_of_joint(robot, i)) {
      return fault;
    }
    if (auto fault = fault_of_mimic(robot, i)) {
      return fault;
    }
  }
  if (auto fault = fault_of_mimic_circles(robot)) {
    return fault;
  }
  for (const LinkPair& pair : robot.allowed.value_or(std::vector<LinkPair>{})) {
    if (pair.a >= pair.b || pair.b >= robot.links.size()) {
      return RobotFault{.kind = ErrorKind::out_of_range,
                        .what = "links " + std::to_string(pair.a) + " and " +
                                std::to_string(pair.b) + " are no pair of links",
                        .remedy = "give two links, the lesser number first"};
    }
  }
  for (const NamedState& state : robot.states) {
    for (const auto& [joint, value] : state.values) {
      if (joint >= robot.joints.size() || !std::isfinite(value)) {
        return RobotFault{.kind = ErrorKind::out_of_range,
                          .what = "state " + quoted_text(state.name) +
                                  " has a joint that does not exist, or a value that is not finite",
                          .remedy = "give joints that exist, and finite values"};
      }
    }
  }
  return fault_of_tree(robot);
}

void check(const Robot& robot) {
  if (const auto fault = find_fault(robot)) {
    throw Error(fault->kind, "robot: " + fault->what, fault->remedy);
  }
}

Pose pose_from_rpy(const Vec3& rpy, const Vec3& xyz) {
  const PlainArithmetic plain;
  if (!is_finite(rpy) || !is_finite(xyz)) {
    throw Error(ErrorKind::not_finite, "pose: roll, pitch, yaw or the shift is not finite",
                "give finite numbers, the angles in radians");
  }
  const double sr = std::sin(rpy.x);
  const double cr = std::cos(rpy.x);
  const double sp = std::sin(rpy.y);
  const double cp = std::cos(rpy.y);
  const double sy = std::sin(rpy.z);
  const double cy = std::cos(rpy.z);
  Pose pose;
  pose.m = {cy * cp,
            (cy * sp) * sr - sy * cr,
            (cy * sp) * cr + sy * sr,
            xyz.x,
            sy * cp,
            (sy * sp) * sr + cy * cr,
            (sy * sp) * cr - cy * sr,
            xyz.y,
            -sp,
            cp * sr,
            cp * cr,
            xyz.z};
  return pose;
}

}  // namespace soms
