/// \file
/// Queries of one point or of n of them, whose answer is one class or its batch.
#pragma once

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/objects.h"

#include <pybind11/pybind11.h>

#include <utility>

namespace soms::python {

/// `query(limits, point)` for three numbers, else `query(limits, points)`.
template <class Query>
py::object answer_points(const py::object& points, const CallLimits& allowed,
                         const py::object& progress, const Query& query) {
  Doubles numbers = doubles_of(points, "points");
  if (is_point(numbers)) {
    const Vec3 point = point_of(numbers, "points");
    return made(run(Work::one, allowed, progress,
                    [&](const Limits& limits) { return query(limits, point); }));
  }
  const Rows<Vec3> places = points_of(std::move(numbers), "points").owned();
  return made(run(Work::many, allowed, progress,
                  [&](const Limits& limits) { return query(limits, places.get()); }));
}

}  // namespace soms::python
