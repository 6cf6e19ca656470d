/// \file
/// Rays and segments as arguments: one or n of them.
#pragma once

#include "soms/query/ray.h"

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/objects.h"

#include <pybind11/pybind11.h>

#include <optional>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace soms::python {

/// Rays by origins, directions and lengths, or segments by origins and ends.
struct RayArguments {
  std::variant<std::vector<Ray>, std::vector<Segment>> lines;
  bool is_one = false;  ///< three numbers were given, not rows of them
};

/// \shape `origins` (3,) or (n, 3); either `directions` or `ends` the same, the other None;
///        `lengths` a number or (n,).
/// \errors ErrorKind::usage.
[[nodiscard]] RayArguments rays_of(const py::object& origins, const py::object& directions,
                                   const py::object& ends, const py::object& lengths);

/// The options of a query of rays. \errors ErrorKind::usage.
[[nodiscard]] RayOptions ray_options(const py::object& skip, std::optional<double> seconds);

/// One line as a batch of one: the answer of `all_hits` has rows either way.
template <class Line>
std::span<const Line> lines_of(const Line& line) {
  return {&line, 1};
}

template <class Line>
std::span<const Line> lines_of(const std::span<const Line>& lines) {
  return lines;
}

/// `query(line)` for one ray or segment, which takes one thread, else `query(lines, parallel)`.
template <class Query>
py::object answer_rays(const RayArguments& arguments, int threads, const py::object& progress,
                       const Query& query) {
  return std::visit(
      [&](const auto& lines) -> py::object {
        using Line = typename std::decay_t<decltype(lines)>::value_type;
        if (arguments.is_one) {
          return made(run(Work::one, threads, progress,
                          [&](const Parallel&) { return query(lines.front()); }));
        }
        return made(run(Work::many, threads, progress, [&](const Parallel& parallel) {
          return query(std::span<const Line>(lines), parallel);
        }));
      },
      arguments.lines);
}

}  // namespace soms::python
