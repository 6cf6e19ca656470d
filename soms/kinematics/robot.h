/// \file
/// What a robot is: links with collision meshes, and joints that make a tree of them.
#pragma once

#include "soms/base/error.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace soms {

/// How a joint moves its child link. Planar and floating joints, which have several values each,
/// are not supported.
enum class JointType : unsigned char {
  fixed,       ///< not at all
  revolute,    ///< by an angle about its axis, within limits
  continuous,  ///< by any angle about its axis
  prismatic,   ///< by a length along its axis, within limits
};

template <>
inline constexpr auto kWords<JointType> = words(
    "JointType",
    "How a joint moves its link: not at all, by an angle within limits or without, by a length.",
    "fixed", "revolute", "continuous", "prismatic");

/// A joint that follows another one: its value is `multiplier * value + offset`, both operations
/// rounded.
struct Mimic {
  std::uint32_t joint = 0;  ///< the one that is followed, which may follow another
  double multiplier = 1;
  double offset = 0;

  [[nodiscard]] bool operator==(const Mimic&) const = default;
};

/// What connects a link to its parent.
struct Joint {
  std::string name;
  JointType type = JointType::fixed;
  std::uint32_t parent = 0;  ///< link
  std::uint32_t child = 0;   ///< link, whose frame is that of the joint
  Pose origin = {};          ///< of the joint at value 0, in the frame of the parent
  Vec3 axis = {1, 0, 0};     ///< in the frame of the joint; any length but 0
  /// Least and greatest value: radians, or the unit of length. Those of a continuous joint are
  /// infinite.
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  std::optional<Mimic> mimic = std::nullopt;

  [[nodiscard]] bool operator==(const Joint&) const = default;
};

/// A rigid body of a robot.
struct Link {
  std::string name;
  std::vector<Mesh> collisions = {};  ///< in the frame of the link; none: it touches nothing

  [[nodiscard]] bool operator==(const Link&) const = default;
};

/// Numbers of two links, the lesser first.
struct LinkPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  [[nodiscard]] auto operator<=>(const LinkPair&) const = default;
};

/// A named set of joint values, such as "ready".
struct NamedState {
  std::string name;
  std::string group = {};                                     ///< of joints; may be empty
  std::vector<std::pair<std::uint32_t, double>> values = {};  ///< joints and their values
  std::vector<std::string> unknown = {};  ///< joints that it names and the robot does not have

  [[nodiscard]] bool operator==(const NamedState&) const = default;
};

/// A robot: a tree of links. Lengths are in one unit (of a URDF file, meters), angles in radians.
struct Robot {
  std::string name = {};
  std::vector<Link> links = {};
  std::vector<Joint> joints = {};
  /// Pairs of links that may touch and are not compared, sorted, each once, as an SRDF file lists
  /// them. Unset: nothing is known, and neighbors are not compared (link_pairs.h).
  std::optional<std::vector<LinkPair>> allowed = std::nullopt;
  std::vector<NamedState> states = {};
  /// How far the surface of a cylinder or sphere may be outside of the true one: the greatest error
  /// of those in `links`.
  double tessellation_error = 0;
  std::string source = {};              ///< path of the file
  std::vector<std::string> notes = {};  ///< what the file holds that was not read or applied

  [[nodiscard]] bool operator==(const Robot&) const = default;
};

/// What is wrong with a robot, and with which link or joint: for readers, who know where in a file
/// that is.
struct RobotFault {
  ErrorKind kind = ErrorKind::bad_file;
  std::string what;
  std::string remedy;
  std::optional<std::uint32_t> link = std::nullopt;
  std::optional<std::uint32_t> joint = std::nullopt;

  [[nodiscard]] bool operator==(const RobotFault&) const = default;
};

/// The first fault of a robot, or nothing: names are given and unique, joints make one tree of all
/// links, axes have a direction, limits are in order, mimic joints end at one that moves, poses are
/// rigid. Meshes are not looked at: whoever builds their trees checks them.
[[nodiscard]] std::optional<RobotFault> find_fault(const Robot& robot);

/// Throws what `find_fault` finds.
/// \errors ErrorKind::bad_file, not_finite, not_rigid, out_of_range.
void check(const Robot& robot);

/// The pose of URDF's `rpy` and `xyz`: rotations about the fixed axes x, y and z, in this order, by
/// roll, pitch and yaw in radians, then the shift. Sines and cosines are those of the C library,
/// whose last bits differ between platforms; the products of them are rounded once each.
/// \errors ErrorKind::not_finite.
[[nodiscard]] Pose pose_from_rpy(const Vec3& rpy, const Vec3& xyz);

}  // namespace soms
