#include "soms/query/print.h"
#include "soms/query/ray.h"
#include "soms/tiles/tiled_queries.h"

#include "python/src/call.h"
#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/ray_arguments.h"
#include "python/src/scene/bodies.h"

#include <optional>
#include <type_traits>

namespace soms::python {

namespace {

constexpr const char* kRaysDoc = R"(

body: a Body, Shape or Mesh. origins: (3,) or (n, 3). directions: the same; they need not have unit
length, t counts in units of them. Or ends: the same, for segments, where t is from 0 to 1. lengths:
of the rays, in units of the directions: a number, or (n,). skip: a triangle that takes no part.
timeout: seconds after which the call ends, with coverage 'cut'. threads: 0 for all processors.
progress: called with the share done.

Raises Error of kind not_finite, out_of_range, usage.
Cost: typically logarithmic in the triangles.
Source: Woop, Benthin and Wald 2013.)";

bool sees_between(const py::object& body, const py::object& a, const py::object& b) {
  const BodyArgument surface(body, "body");
  const Vec3 from = point_of(doubles_of(a, "a"), "a");
  const Vec3 to = point_of(doubles_of(b, "b"), "b");
  return run(Work::one, 1, py::none(),
             [&](const Limits&) { return sees(surface.get(), from, to); });
}

/// Answers of tiles, of one line or of many.
template <class Batch, class Line>
auto of_tiles(const Batch& query, const TiledBody& tiles, const Line& line,
              const RayOptions& options, const Limits& limits = {}) {
  if constexpr (std::is_same_v<Line, Ray>) {
    return query(tiles, rays_in(line), options, limits).at(0);
  } else {
    return query(tiles, line, options, limits);
  }
}

/// Binds `query(body, one or more lines, options...)`; `takes_tiles` if tiles answer it, too.
template <bool takes_tiles, class Query>
void def_rays(py::module_& module, const char* name, const Query& query, const char* what) {
  const std::string doc = std::string(name) +
                          "(body, origins, directions=None, *, ends=None, lengths=inf, skip=None, "
                          "timeout=None, threads=1, progress=None)\n\n" +
                          what + kRaysDoc;
  const auto ask = [query](const py::object& body, const py::object& origins,
                           const py::object& directions, const py::object& ends,
                           const py::object& lengths, const py::object& skip,
                           std::optional<double> timeout, int threads, const py::object& progress) {
    const RayOptions options = ray_options(skip);
    if constexpr (takes_tiles) {
      if (py::isinstance<TileSet>(body)) {
        const TiledBody tiles{body.cast<TileSet>()};
        return answer_rays(rays_of(origins, directions, ends, lengths), {threads, timeout},
                           progress, [&](const auto& lines, const Limits& limits) {
                             return of_tiles(query, tiles, lines, options, limits);
                           });
      }
    }
    const BodyArgument surface(body, "body", threads);
    return answer_rays(rays_of(origins, directions, ends, lengths), {threads, timeout}, progress,
                       [&](const auto& lines, const Limits& limits) {
                         return query(surface.get(), lines, options, limits);
                       });
  };
  def_function(module, name, ask, doc,
               with_limits({{"body"},
                            {"origins"},
                            {"directions", py::none()},
                            {"ends", py::none(), true},
                            {"lengths", py::float_(Ray{}.length), true},
                            {"skip", py::none(), true}}));
}

}  // namespace

void bind_rays(py::module_& module) {
  bind_answers_of<ClosestHit>(module);
  bind_answers_of<AnyHit>(module);
  bind_answer<AllHits>(module);
  def_rays<true>(
      module, "closest_hit", [](const auto&... of) { return closest_hit(of...); },
      "The first point of a surface on a ray or segment. Triangles are closed sets, so no ray "
      "slips\nbetween two that share an edge. Returns ClosestHit, or ClosestHitBatch for n.");
  def_rays<true>(
      module, "any_hit", [](const auto&... of) { return any_hit(of...); },
      "Does a ray or segment hit anything? Returns AnyHit, or AnyHitBatch for n.");
  def_rays<false>(
      module, "all_hits",
      [](const Body& body, const auto& lines, const auto&... others) {
        return all_hits(body, rays_in(lines), others...);
      },
      "All places where rays or segments meet a surface, in the order of t; triangles that meet "
      "there are\none crossing. Returns AllHits.");
  module.def(
      "sees", &sees_between, py::arg("body"), py::arg("a"), py::arg("b"),
      "sees(body, a, b) -> bool\n\nTrue if nothing of the surface is on the segment from a to "
      "b, both (3,), ends included.");
}

}  // namespace soms::python
