/// \file
/// What recordings hold, as arrays and values of Python.
#pragma once

#include "soms/scene/recording.h"

#include "python/src/answer.h"
#include "python/src/scene/scene_columns.h"

#include <pybind11/pybind11.h>

namespace soms::python {

/// What a recording says of meshes and bodies, a frame, and how it ended.
void bind_recorded(py::module_& module);

void bind_recording_writer(py::module_& module);
void bind_replay(py::module_& module);

}  // namespace soms::python
