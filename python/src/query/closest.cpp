#include "soms/query/closest.h"

#include "soms/query/print.h"
#include "soms/query/signed_closest.h"
#include "soms/tiles/tiled_queries.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/point_query.h"
#include "python/src/query/signed_distance.h"
#include "python/src/scene/bodies.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kClosestDoc =
    R"(closest(body, points, *, at_most=inf, timeout=None, threads=1, progress=None)

Where is a surface nearest to a point? Of a ClosedBody, on which side is the point, too?

body: a Body, Shape or Mesh, or a ClosedBody. points: (3,) or (n, 3). at_most: beyond this the answer
is farther, and sooner. timeout, threads, progress: as for contains.

Returns Closest for one point, ClosestBatch for n; SignedClosest and SignedClosestBatch of a
ClosedBody. The least distance is from lower to upper, which are equal doubles or neighbors. Raises
Error of kind not_finite, out_of_range, usage.
Cost: typically logarithmic in the triangles.
Source: Roussopoulos, Kelley and Vincent 1995.)";

constexpr const char* kNearestDoc =
    R"(nearest_triangles(body, points, count, *, at_most=inf, timeout=None, threads=1, progress=None)

The nearest triangles of each point, in the order of their exact distances, then by number.

points: (n, 3). count: most triangles of a point. Others: as for closest. Returns NearTriangles.)";

constexpr const char* kNearDoc =
    R"(near_triangles(body, points, radius, *, timeout=None, threads=1, progress=None)

All triangles that are at most a radius from each point, decided exactly, in the order of
nearest_triangles.

points: (n, 3). radius: a number from 0 on. Others: as for closest. Returns NearTriangles.)";

Closest closest_of_tiles(const TiledBody& tiles, const Vec3& point, const ClosestOptions& options,
                         const Limits& limits) {
  return closest(tiles, {&point, 1}, options, limits).at(0);
}

ClosestBatch closest_of_tiles(const TiledBody& tiles, std::span<const Vec3> points,
                              const ClosestOptions& options, const Limits& limits) {
  return closest(tiles, points, options, limits);
}

py::object query_closest(const py::object& body, const py::object& points, double at_most,
                         std::optional<double> timeout, int threads, const py::object& progress) {
  const ClosestOptions options{.at_most = at_most};
  const auto ask = [&](const auto& surface) {
    return answer_points(points, {threads, timeout}, progress,
                         [&](const Limits& limits, const auto& places) {
                           return closest(surface, places, options, limits);
                         });
  };
  if (const auto* const closed = inside<ClosedBody>(body)) {
    return ask(*closed);
  }
  if (py::isinstance<TileSet>(body)) {
    const TiledBody tiles{body.cast<TileSet>()};
    return answer_points(points, {threads, timeout}, progress,
                         [&](const Limits& limits, const auto& places) {
                           return closest_of_tiles(tiles, places, options, limits);
                         });
  }
  return ask(BodyArgument(body, "body", threads).get());
}

py::object nearest(const py::object& body, const py::object& points, std::size_t count,
                   double at_most, std::optional<double> timeout, int threads,
                   const py::object& progress) {
  const BodyArgument surface(body, "body", threads);
  const Rows<Vec3> places = points_of(points, "points").owned();
  const ClosestOptions options{.at_most = at_most};
  return made(run(Work::many, {threads, timeout}, progress, [&](const Limits& limits) {
    return nearest_triangles(surface.get(), places.get(), count, options, limits);
  }));
}

py::object near(const py::object& body, const py::object& points, double radius,
                std::optional<double> timeout, int threads, const py::object& progress) {
  const BodyArgument surface(body, "body", threads);
  const Rows<Vec3> places = points_of(points, "points").owned();
  return made(run(Work::many, {threads, timeout}, progress, [&](const Limits& limits) {
    return near_triangles(surface.get(), places.get(), radius, {}, limits);
  }));
}

void bind_signed(py::module_& module) {
  bind_answer<SignedClosest>(module)
      .derived(
          "lower", [](const SignedClosest& c) { return c.distance().lower; },
          "The signed distance, below 0 inside, is at least this,")
      .derived(
          "upper", [](const SignedClosest& c) { return c.distance().upper; }, "and at most this.")
      .derived(
          "signed",
          [](const SignedClosest& c) {
            return signed_distance(c.closest.distance.upper, c.side, c.closest.coverage);
          },
          "The signed distance as one number, as signed_distance returns it.");
  bind_batch<SignedClosest>(module).derived(
      "signed",
      [](const SignedClosestBatch& b) {
        const std::vector<double> all = signed_distances(b.closest, b.side);
        return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
      },
      "(n,) float64: the signed distances as signed_distance returns them; a copy.");
}

}  // namespace

void bind_closest(py::module_& module) {
  bind_answers_of<Closest>(module);
  bind_signed(module);
  bind_answer<NearTriangles>(module);
  def_function(
      module, "closest", &query_closest, kClosestDoc,
      with_limits({{"body"}, {"points"}, {"at_most", py::float_(ClosestOptions{}.at_most), true}}));
  def_function(module, "nearest_triangles", &nearest, kNearestDoc,
               with_limits({{"body"},
                            {"points"},
                            {"count"},
                            {"at_most", py::float_(ClosestOptions{}.at_most), true}}));
  def_function(module, "near_triangles", &near, kNearDoc,
               with_limits({{"body"}, {"points"}, {"radius"}}));
}

}  // namespace soms::python
