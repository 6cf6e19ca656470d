/// \file
/// Does a robot touch anything on its way from state to state? Proved for all times in between.
///
/// \code
/// soms::Robot robot;  // a ball on a rail
/// robot.links = {{"rail"}, {"ball", {soms::generate_sphere(320)}}};
/// robot.joints = {{"slide", soms::JointType::prismatic, 0, 1}};
/// const std::vector<soms::Mesh> cell{soms::generate_sphere(320)};
/// const soms::RobotModel model(robot, cell);
/// const std::vector<double> states{6, 3, -3};  // of the one joint
/// const soms::RobotPath path = soms::robot_path(model, states);
/// for (const soms::RobotSegment& segment : path.segments) {
///   std::cout << segment.verdict << '\n';
/// }
/// std::cout << "both ends of segment " << *path.blocked << " are free: "
///           << (path.states[2].verdict == soms::RobotVerdict::free) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// free
/// contact
/// both ends of segment 1 are free: 1
/// \endverbatim
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/motion/first_contact.h"
#include "soms/query/answer.h"
#include "soms/robot/robot_model.h"
#include "soms/robot/robot_query.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soms {

/// What is proved of the way from one state to the next.
struct RobotSegment {
  /// `grazing` also where a state is undecided, and nothing is proved to touch.
  ContactVerdict verdict = ContactVerdict::free;
  /// Holds the time of the first contact, from 0 to 1. Before `lower` no surfaces meet, neither by
  /// the law in real numbers nor at any `state_between`. At `upper` that state is in contact, as
  /// `robot_contacts` decides it; infinity where none is proved. [1, infinity] where all is free,
  /// [0, 0] where the first state is in contact.
  Bracket t = {};
  /// The pair in contact at `t.upper`; where none is proved, the one that is next to it at
  /// `t.lower`. Nothing where all is free, or where a state is undecided and all else free.
  std::optional<RobotPair> pair = std::nullopt;
  /// Where that is, in the cell. Nothing where a body is inside another in a state.
  std::optional<Vec3> point = std::nullopt;
  /// Pairs of bodies that are undecided in the first and in the last state, together.
  std::uint64_t undecided = 0;
  Coverage coverage = Coverage::complete;
  Cost cost = {};  ///< without the states

  [[nodiscard]] bool operator==(const RobotSegment&) const = default;
};

/// Answer of `robot_path`.
struct RobotPath {
  /// n - 1 for n states; with RobotPathOptions::first_blocked, up to the first that is not free.
  std::vector<RobotSegment> segments = {};
  std::vector<RobotAnswer> states = {};               ///< n, of `robot_contacts`
  std::optional<std::size_t> blocked = std::nullopt;  ///< the first segment that is not free
  Cost cost = {};                                     ///< of states and segments

  [[nodiscard]] bool operator==(const RobotPath&) const = default;

  [[nodiscard]] std::size_t size() const { return segments.size(); }

  [[nodiscard]] const RobotSegment& at(std::size_t segment) const { return segments.at(segment); }
};

/// Options of `robot_path`.
struct RobotPathOptions {
  RobotOptions states = {};    ///< what is answered of the states
  bool first_blocked = false;  ///< end at the first segment that is not free

  [[nodiscard]] bool operator==(const RobotPathOptions&) const = default;
};

/// Whether a robot touches anything on its way through states, of all that `model` compares.
///
/// Between two states every joint goes straight in its value: `from + t * (to - from)`, of mimic
/// joints between their two values. A continuous joint takes the way of its numbers, not the
/// shorter one around. Each state is decided once, by `robot_contacts`.
///
/// `free` holds at every time, for the robot in real numbers and in every `state_between`;
/// `contact` says that the state at `t.upper` is in contact by the library's exact decision.
/// `grazing` is what remains: at `t.lower` surfaces are nearer than the rounding of poses, and no
/// time was found with a contact. That rounding is some 2^-40 of the robot's size for each joint.
/// Treat `grazing` as a contact.
///
/// What starts outside of a closed body comes inside through its surface alone, so between free
/// states surfaces decide. What an open body encloses is looked at in states only: something may
/// pass through its opening and back in between.
///
/// \shape   `states`: n x k, row by row, as `robot_contacts`. One state has no segment.
/// \errors  As `robot_contacts`. ErrorKind::out_of_range for a segment, which is named by its
/// index:
///          a joint turns by more than 2^20 radians or has an angle beyond 2^40; a body may come
///          beyond 2^300.
/// \cost    That of the states, and a few times as much. A deadline leaves segments `cut`.
/// \threads Any number of callers; segments are shared by as many threads as `limits` says.
/// \source  Schwarzer, Saha and Latombe 2005 (lengths of ways); `first_contact` has the others.
[[nodiscard]] RobotPath robot_path(const RobotModel& model, std::span<const double> states,
                                   const RobotPathOptions& options = {}, const Limits& limits = {});

}  // namespace soms
