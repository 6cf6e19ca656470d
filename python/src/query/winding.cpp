#include "soms/query/winding.h"

#include "soms/query/print.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/point_query.h"
#include "python/src/scene/bodies.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kWindingDoc =
    R"(winding(index, points, *, width=1e-9, timeout=None, threads=1, progress=None)

The generalized winding number of points, as a proved bracket: about any triangles that face the same
way, open or closed.

index: a WindingIndex, or a Body, Shape or Mesh, of which one is made each time. points: (3,) or
(n, 3). width: by how much triangles that are far may widen the bracket. timeout, threads, progress:
as for contains.

Returns Winding for one point, WindingBatch for n. Raises Error of kind not_finite, out_of_range,
usage.
Source: Jacobson, Kavan and Sorkine-Hornung 2013; Barill et al. 2018.)";

WindingIndex index_of(const Body& body, int threads, const py::object& progress) {
  return run(Work::many, threads, progress,
             [&](const Limits& limits) { return WindingIndex(body, limits); });
}

py::object query_winding(const py::object& index, const py::object& points, double width,
                         std::optional<double> timeout, int threads, const py::object& progress) {
  const WindingOptions options{.width = width};
  const auto ask = [&](const WindingIndex& of) {
    return answer_points(points, {threads, timeout}, progress,
                         [&](const Limits& limits, const auto& places) {
                           return winding(of, places, options, limits);
                         });
  };
  if (const auto* const made = inside<WindingIndex>(index)) {
    return ask(*made);
  }
  return ask(index_of(BodyArgument(index, "index", threads).get(), threads, py::none()));
}

void bind_index(py::module_& module) {
  py::class_<WindingIndex> index(module, "WindingIndex",
                                 R"(WindingIndex(body, *, threads=1, progress=None)

A body, and what its winding numbers are made of. Made once, queried often. O(n log n).)");
  index.def(py::init([](const py::object& body, int threads, const py::object& progress) {
              return index_of(BodyArgument(body, "body", threads).get(), threads, progress);
            }),
            py::arg("body"), py::kw_only(), py::arg("threads") = 1,
            py::arg("progress") = py::none());
  index.def_property_readonly("body", &WindingIndex::body, "The Body.");
  index.def_property_readonly("boundary_edges", &WindingIndex::boundary_edges,
                              "Edges of the boundary: 0 if every winding number is an integer.");
  index.def_property_readonly("memory", &WindingIndex::memory, "Bytes held beside the body.");
  index.def(
      "__eq__", [](const WindingIndex& a, const WindingIndex& b) { return a == b; },
      py::is_operator());
  index.attr("__hash__") = py::none();
  index.def("__repr__", &printed<WindingIndex>);
  index.def(py::pickle([](const WindingIndex& i) { return py::make_tuple(i.body()); },
                       [](const py::tuple& s) { return WindingIndex(s[0].cast<Body>()); }));
}

}  // namespace

void bind_winding(py::module_& module) {
  bind_index(module);
  bind_answers_of<Winding>(module);
  def_function(
      module, "winding", &query_winding, kWindingDoc,
      with_limits({{"index"}, {"points"}, {"width", py::float_(WindingOptions{}.width), true}}));
}

}  // namespace soms::python
