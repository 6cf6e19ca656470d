/// \file
/// Robots as objects of Python, and the arrays that states of them are.
#pragma once

#include "soms/kinematics/kinematics.h"
#include "soms/kinematics/robot.h"

#include "python/src/arrays.h"
#include "python/src/errors.h"

#include <pybind11/pybind11.h>

#include <cstdint>
#include <memory>
#include <utility>

namespace soms::python {

/// A robot, and its joints in the order in which poses can be computed.
struct HeldRobot {
  explicit HeldRobot(Robot given) : robot(std::move(given)), kinematics(robot) {}

  Robot robot;
  Kinematics kinematics;
};

using SharedRobot = std::shared_ptr<HeldRobot>;

/// Joint values that were given.
struct States {
  Rows<double> numbers;  ///< row by row
  std::size_t rows = 0;
  bool is_one = false;  ///< one state, not rows of them
};

/// \shape (k,) or (n, k) for k movable joints. \errors ErrorKind::usage.
[[nodiscard]] States states_of(py::handle given, const Kinematics& kinematics);

/// A link by its number or name. \errors ErrorKind::usage, out_of_range; `what` is the argument.
[[nodiscard]] std::uint32_t link_of(py::handle given, const Robot& robot, const char* what);

/// Pairs of links. \shape (m, 2) uint32, a copy.
[[nodiscard]] py::array link_pairs_array(const std::vector<LinkPair>& pairs);

}  // namespace soms::python
