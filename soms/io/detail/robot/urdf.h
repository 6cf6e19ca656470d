/// \file
/// The format URDF: links and joints of a robot.
#pragma once

#include "soms/io/detail/source.h"
#include "soms/io/robot.h"

namespace soms::detail {

/// \errors As `read_robot`.
[[nodiscard]] Robot read_urdf(Source& source, const RobotReadOptions& options);

}  // namespace soms::detail
