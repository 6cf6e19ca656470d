/// \file
/// Arguments that stand for poses: Pose, matrices, quaternions, shifts.
#pragma once

#include "soms/base/pose.h"

#include "python/src/arrays.h"
#include "python/src/errors.h"

#include <pybind11/pybind11.h>

namespace soms::python {

/// One pose. \shape A Pose; (3, 4), (4, 4); (7,) as x y z qw qx qy qz; (3,) as x y z.
/// \errors ErrorKind::usage, not_finite, not_rigid.
[[nodiscard]] Pose pose_of(py::handle given);

/// n poses, in memory that no other thread can write to. Those of 12 numbers are not checked here:
/// queries do. \shape A list of Pose; (n, 3, 4), (n, 4, 4), (n, 12), (n, 7), (n, 3).
/// \errors As `pose_of`, with the number of the pose.
[[nodiscard]] Rows<Pose> poses_of(py::handle given);

}  // namespace soms::python
