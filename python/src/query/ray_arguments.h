/// \file
/// Rays and segments as arguments: one or n of them.
#pragma once

#include "soms/query/ray.h"

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/objects.h"

#include <pybind11/pybind11.h>

#include <span>
#include <vector>

namespace soms::python {

/// Rays by origins, directions and lengths, or by origins and ends.
struct RayArguments {
  std::vector<Ray> rays;
  bool is_one = false;  ///< three numbers were given, not rows of them
};

/// \shape `origins` (3,) or (n, 3); either `directions` or `ends` the same, the other None;
///        `lengths` a number or (n,).
/// \errors ErrorKind::usage.
[[nodiscard]] RayArguments rays_of(const py::object& origins, const py::object& directions,
                                   const py::object& ends, const py::object& lengths);

/// The options of a query of rays. \errors ErrorKind::usage.
[[nodiscard]] RayOptions ray_options(const py::object& skip);

/// One ray as a batch of one: the answer of `all_hits` has rows either way.
[[nodiscard]] inline std::span<const Ray> rays_in(const Ray& ray) {
  return {&ray, 1};
}

[[nodiscard]] inline std::span<const Ray> rays_in(std::span<const Ray> rays) {
  return rays;
}

/// `query(ray, limits)` for one ray, `query(rays, limits)` for more.
template <class Query>
py::object answer_rays(const RayArguments& arguments, const CallLimits& allowed,
                       const py::object& progress, const Query& query) {
  const std::span<const Ray> rays = arguments.rays;
  if (arguments.is_one) {
    return made(run(Work::one, allowed, progress,
                    [&](const Limits& limits) { return query(rays.front(), limits); }));
  }
  return made(run(Work::many, allowed, progress,
                  [&](const Limits& limits) { return query(rays, limits); }));
}

}  // namespace soms::python
