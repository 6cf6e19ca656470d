/// \file
/// The format SRDF: which links of a robot may touch, and its named states.
#pragma once

#include "soms/io/detail/source.h"
#include "soms/kinematics/robot.h"

namespace soms::detail {

/// Sets Robot::allowed and Robot::states. \errors As `read_semantics`.
void read_srdf(Source& source, Robot& robot);

}  // namespace soms::detail
