/// \file
/// Rows of scenes as arrays of numpy.
#pragma once

#include "soms/scene/contact_tracker.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include "python/src/answer.h"

namespace soms::python {

/// (kind, number) of a body.
template <>
inline constexpr bool kIsTuple<SceneBody> = true;

/// Kind and number of bodies, -1, -1 for none. \shape (n, 2), a copy.
template <>
struct Column<std::optional<SceneBody>> {
  static py::array make(const std::vector<std::optional<SceneBody>>& values, py::handle owner);
};

}  // namespace soms::python
