/// \file
/// Robots printed by `<<`: "Robot{panda, 12 links, 11 joints}".
#pragma once

#include "soms/kinematics/robot.h"

#include <iosfwd>

namespace soms {

enum class JointType : unsigned char;
struct Mimic;
struct Joint;
struct Link;
struct LinkPair;
struct NamedState;
struct Robot;
struct RobotFault;
struct PrimitiveMesh;

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const Mimic& value);
std::ostream& operator<<(std::ostream& out, const Joint& value);
std::ostream& operator<<(std::ostream& out, const Link& value);
std::ostream& operator<<(std::ostream& out, const LinkPair& value);
std::ostream& operator<<(std::ostream& out, const NamedState& value);
std::ostream& operator<<(std::ostream& out, const Robot& value);
std::ostream& operator<<(std::ostream& out, const RobotFault& value);
std::ostream& operator<<(std::ostream& out, const PrimitiveMesh& value);

}  // namespace soms
