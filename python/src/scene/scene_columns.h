/// \file
/// Rows of scenes as arrays of numpy.
#pragma once

#include "soms/scene/contact_tracker.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"

#include "python/src/arrays.h"

namespace soms::python {

/// mover, part, i, j.
template <>
struct RowType<EnvironmentContact> {
  static py::dtype get();
};

/// a, b, i, j.
template <>
struct RowType<MoverContact> {
  static py::dtype get();
};

/// mover, part, i, j, lower, upper, point_a, point_b.
template <>
struct RowType<EnvironmentGap> {
  static py::dtype get();
};

/// a, b, i, j, lower, upper, point_a, point_b.
template <>
struct RowType<MoverGap> {
  static py::dtype get();
};

/// mover, part, change.
template <>
struct RowType<EnvironmentEvent> {
  static py::dtype get();
};

/// a, b, change.
template <>
struct RowType<MoverEvent> {
  static py::dtype get();
};

/// kind, number.
template <>
struct RowType<SceneBody> {
  static py::dtype get();
};

/// Kind and number of bodies, -1, -1 for none. \shape (n, 2), a copy.
template <>
struct Column<std::optional<SceneBody>> {
  static py::array make(const std::vector<std::optional<SceneBody>>& values, py::handle owner);
};

}  // namespace soms::python
