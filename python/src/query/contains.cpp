#include "soms/query/contains.h"

#include "soms/query/contains_parts.h"
#include "soms/query/print.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/poses.h"
#include "python/src/query/point_query.h"
#include "python/src/scene/bodies.h"

#include <pybind11/stl.h>

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kContainsDoc =
    R"(contains(body, points, *, timeout=None, threads=1, progress=None)

Is a point inside a closed body? Decided exactly; orientation of the triangles plays no part.

body: a ClosedBody, or a Body, Shape or Mesh, which is checked first each time; or a DividedBody, for
the parts that hold each point. points: (3,) or (n, 3). timeout: seconds after
which the call ends, with coverage 'cut'. threads: 0 for all processors. progress: called with the
share done.

Returns Contains for one point, ContainsBatch for n; ContainsParts and ContainsPartsBatch of a
DividedBody. Raises Error of kind not_closed, not_finite, out_of_range, usage.
Cost: typically a microsecond a point and less.
Source: Edelsbrunner and Muecke 1990, Simulation of Simplicity.)";

py::object query_contains(const py::object& body, const py::object& points,
                          std::optional<double> timeout, int threads, const py::object& progress) {
  const auto ask = [&](const auto& surface) {
    return answer_points(points, {threads, timeout}, progress,
                         [&](const Limits& limits, const auto& places) {
                           return contains(surface, places, limits);
                         });
  };
  if (const auto* const closed = inside<ClosedBody>(body)) {
    return ask(*closed);
  }
  if (const auto* const parted = inside<DividedBody>(body)) {
    return ask(*parted);
  }
  const BodyArgument surface(body, "body", threads);
  return answer_points(points, {threads, timeout}, progress,
                       [&](const Limits& limits, const auto& places) {
                         const Limits whole = limits.silent().without_deadline();
                         return contains(ClosedBody(surface.get(), whole), places, limits);
                       });
}

void bind_closed_body(py::module_& module) {
  py::class_<ClosedBody> closed(module, "ClosedBody",
                                R"(ClosedBody(body, *, threads=1, progress=None)

A body whose surface was found to be closed where its pose moves it. Checked once, queried often.

Raises Error of kind not_closed, which counts the odd edges and names the first. O(n).)");
  closed.def(py::init([](const py::object& body, int threads, const py::object& progress) {
               const BodyArgument given(body, "body", threads);
               return run(Work::many, threads, progress,
                          [&](const Limits& limits) { return ClosedBody(given.get(), limits); });
             }),
             py::arg("body"), py::kw_only(), py::arg("threads") = 1,
             py::arg("progress") = py::none());
  closed.def_property_readonly("body", &ClosedBody::body, "The Body.");
  closed.def(
      "at", [](const ClosedBody& b, const py::object& pose) { return b.at(pose_of(pose)); },
      py::arg("pose"),
      "at(pose) -> ClosedBody\n\nThe same body at another pose. Raises Error of kind not_closed if "
      "a "
      "T-junction opens there.");
  closed.def(
      "__eq__", [](const ClosedBody& a, const ClosedBody& b) { return a == b; }, py::is_operator());
  closed.attr("__hash__") = py::none();
  closed.def("__repr__", &printed<ClosedBody>);
  closed.def(py::pickle([](const ClosedBody& b) { return py::make_tuple(b.body()); },
                        [](const py::tuple& s) { return ClosedBody(s[0].cast<Body>()); }));
}

void bind_parted_body(py::module_& module) {
  AnswerClass<DividedPart> part(module, "DividedPart", "A part of a DividedBody.");
  part.derived(
          "named",
          [](const DividedPart& p) {
            return p.named == Part::kNoParent ? std::optional<std::uint32_t>() : p.named;
          },
          "Index in Mesh.parts, or None.")
      .derived(
          "joined",
          [](const DividedPart& p) {
            std::vector<std::optional<std::uint32_t>> others;
            for (const std::uint32_t other : p.joined) {
              others.push_back(other == Part::kNoParent ? std::nullopt : std::optional(other));
            }
            return others;
          },
          "A list: the other parts of a body of several, by their indices; None for no part.")
      .field("first", &DividedPart::first, "Its first triangle.")
      .field("triangles", &DividedPart::triangles, "How many it has.")
      .field("closed", &DividedPart::closed, "By itself, at the body's pose.")
      .field("odd_edges", &DividedPart::odd_edges, "Edges of an odd number of its triangles.");
  py::class_<DividedBody> parted(
      module, "DividedBody",
      R"(DividedBody(body, partition='named', *, threads=1, progress=None)

A body whose parts were found and checked, each by itself. Open parts are no error.

partition: 'named' by the parts of the file, or 'connected' by vertices in one place. O(n).)");
  parted.def(py::init([](const py::object& body, const py::object& partition, int threads,
                         const py::object& progress) {
               const BodyArgument given(body, "body", threads);
               const auto chosen = enum_of<Partition>(partition, "partition");
               return run(Work::many, threads, progress, [&](const Limits& limits) {
                 return DividedBody(given.get(), chosen, limits);
               });
             }),
             py::arg("body"), py::arg("partition") = "named", py::kw_only(), py::arg("threads") = 1,
             py::arg("progress") = py::none());
  parted.def_property_readonly("body", &DividedBody::body, "The Body.");
  parted.def_property_readonly(
      "parts",
      [](const DividedBody& b) {
        return std::vector<DividedPart>(b.parts().begin(), b.parts().end());
      },
      "A list of DividedPart.");
  parted.def_property_readonly("open_parts", &DividedBody::open_parts, "How many are open.");
  parted.def(
      "__eq__", [](const DividedBody& a, const DividedBody& b) { return a == b; },
      py::is_operator());
  parted.attr("__hash__") = py::none();
  parted.def("__repr__", &printed<DividedBody>);
  parted.def(py::pickle(
      [](const DividedBody& b) { return py::make_tuple(b.body(), member(b.partition())); },
      [](const py::tuple& s) {
        return DividedBody(s[0].cast<Body>(), enum_of<Partition>(s[1], "partition"));
      }));
}

void bind_point_answers(py::module_& module) {
  bind_answers_of<Contains>(module);
}

void bind_part_answers(py::module_& module) {
  bind_answer<ContainsParts>(module);
  bind_answer<ContainsPartsBatch>(module);
}

}  // namespace

void bind_contains(py::module_& module) {
  bind_closed_body(module);
  bind_parted_body(module);
  bind_point_answers(module);
  bind_part_answers(module);
  def_function(module, "contains", &query_contains, kContainsDoc,
               with_limits({{"body"}, {"points"}}));
}

}  // namespace soms::python
