#include "python/src/query/signed_distance.h"

#include "soms/query/signed_closest.h"
#include "soms/query/winding.h"

#include "python/src/arrays.h"
#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/scene/bodies.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace soms::python {

namespace {

constexpr const char* kSignedDistanceDoc =
    R"(signed_distance(model, points, *, at_most=inf, timeout=None, threads=1, progress=None)

How far is a surface from a point? Below 0 inside.

The side is exact where the model is closed. An open model has the side that its winding number gives
(1/2 is the border), so its triangles must face outward.

model: a Body, Shape or Mesh; or a ClosedBody or WindingIndex, which saves the preparation of a further
call. points: (3,) or (n, 3). at_most: beyond this the answer is an infinity, and sooner. timeout,
threads, progress: as for contains.

Returns a float for one point, an array (n,) of float64 for n: the least double that is not below the
distance, with the sign; 0 on the surface. NaN where it is not known: time ended, or the winding number
may be 1/2. closest and winding return brackets.
Raises Error of kind not_finite, out_of_range, usage.
Cost: of closest, and contains or winding; O(n) or O(n log n) for n triangles to prepare a model.)";

std::vector<double> distances(const ClosedBody& body, std::span<const Vec3> points,
                              const ClosestOptions& options, const Limits& limits) {
  const SignedClosestBatch found = closest(body, points, options, limits);
  return signed_distances(found.closest, found.side);
}

std::vector<double> distances(const WindingIndex& index, std::span<const Vec3> points,
                              const ClosestOptions& options, const Limits& limits) {
  const ClosestBatch found = closest(index.body(), points, options, limits);
  return signed_distances(found, winding(index, points, {}, limits).side);
}

/// The body, if it is closed.
std::optional<ClosedBody> closed_body(const Body& body, const Limits& limits) {
  try {
    return ClosedBody(body, limits.without_deadline());
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::not_closed) {
      throw;
    }
    return std::nullopt;
  }
}

std::vector<double> distances(const Body& body, std::span<const Vec3> points,
                              const ClosestOptions& options, const Limits& limits) {
  if (const std::optional<ClosedBody> closed = closed_body(body, limits)) {
    return distances(*closed, points, options, limits);
  }
  return distances(WindingIndex(body, limits.without_deadline()), points, options, limits);
}

template <class Model>
py::object ask(const Model& model, const py::object& points, const ClosestOptions& options,
               const CallLimits& allowed, const py::object& progress) {
  Doubles numbers = doubles_of(points, "points");
  const auto found = [&](std::span<const Vec3> places) {
    return run(Work::many, allowed, progress,
               [&](const Limits& limits) { return distances(model, places, options, limits); });
  };
  if (is_point(numbers)) {
    const Vec3 point = point_of(numbers, "points");
    return py::float_(found(std::span(&point, 1)).front());
  }
  const Rows<Vec3> places = points_of(std::move(numbers), "points").owned();
  const std::vector<double> all = found(places.get());
  return py::array_t<double>(static_cast<py::ssize_t>(all.size()), all.data());
}

py::object query_signed_distance(const py::object& model, const py::object& points, double at_most,
                                 std::optional<double> timeout, int threads,
                                 const py::object& progress) {
  const ClosestOptions options{.at_most = at_most};
  if (const auto* const closed = inside<ClosedBody>(model)) {
    return ask(*closed, points, options, {threads, timeout}, progress);
  }
  if (const auto* const index = inside<WindingIndex>(model)) {
    return ask(*index, points, options, {threads, timeout}, progress);
  }
  return ask(BodyArgument(model, "model", threads).get(), points, options, {threads, timeout},
             progress);
}

}  // namespace

double signed_distance(double upper, Side side, Coverage coverage) {
  if (upper == 0) {
    return 0;
  }
  if (side == Side::undecided || coverage == Coverage::cut) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return side == Side::inside ? -upper : side == Side::on ? 0 : upper;
}

std::vector<double> signed_distances(const ClosestBatch& closest, const std::vector<Side>& sides) {
  std::vector<double> all;
  all.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    all.push_back(signed_distance(closest.upper[i], sides[i], closest.coverage[i]));
  }
  return all;
}

void bind_signed_distance(py::module_& module) {
  def_function(
      module, "signed_distance", &query_signed_distance, kSignedDistanceDoc,
      with_limits(
          {{"model"}, {"points"}, {"at_most", py::float_(ClosestOptions{}.at_most), true}}));
}

}  // namespace soms::python
