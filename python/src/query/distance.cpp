#include "soms/query/distance.h"

#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/bind.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kDistanceDoc =
    R"(distance(a, b, poses=None, *, at_most=inf, seconds=None, threads=1, progress=None)

The least distance of two surfaces: 0 exactly where they overlap. A body wholly inside another has a
distance above 0 from it.

a, b, poses, seconds, threads, progress: as for overlap. at_most: beyond this the answer is farther,
and sooner.

Returns Distance, or with poses DistanceBatch. The least distance is from lower to upper, which are
equal doubles or neighbors. Raises Error as overlap does.
Cost: typically logarithmic in the triangles.
Source: Larsen, Gottschalk, Lin and Manocha 2000.)";

py::object query_distance(const py::object& a, const py::object& b, const py::object& poses,
                          double at_most, std::optional<double> seconds, int threads,
                          const py::object& progress) {
  const DistanceOptions options{.at_most = at_most, .deadline = deadline_in(seconds)};
  return answer_poses_or_tiles(a, b, poses, threads, progress,
                               [&](const Parallel& parallel, const auto&... bodies) {
                                 return distance(bodies..., options, parallel);
                               });
}

}  // namespace

void bind_distance(py::module_& module) {
  AnswerClass<Distance> one(module, "Distance", "Answer of distance.");
  one.derived(
         "lower", [](const Distance& d) { return d.distance.lower; },
         "The largest double that is not above the distance.")
      .derived(
          "upper", [](const Distance& d) { return d.distance.upper; },
          "The least double that is not below it.")
      .field("triangles", &Distance::triangles,
             "(triangle of a, triangle of b): the least pair at this distance; None if farther.")
      .field("point_a", &Distance::point_a, "(3,): the end of a shortest segment on a, in world.")
      .field("point_b", &Distance::point_b, "(3,): the other end, on b.")
      .field("farther", &Distance::farther, "The distance exceeds at_most.")
      .field("coverage", &Distance::coverage, "Coverage.")
      .field("cost", &Distance::cost, "Cost.");
  AnswerClass<DistanceBatch> batch(module, "DistanceBatch", "Answers of distance for n poses.");
  batch.column("lower", &DistanceBatch::lower, "(n,) float64.")
      .column("upper", &DistanceBatch::upper, "(n,) float64.")
      .column("triangles", &DistanceBatch::triangles, "(n, 2) int64, -1 where there is no pair.")
      .column("point_a", &DistanceBatch::point_a, "(n, 3) float64; 0 where there is no pair.")
      .column("point_b", &DistanceBatch::point_b, "(n, 3) float64; 0 where there is no pair.")
      .column("farther", &DistanceBatch::farther, "(n,) bool.")
      .column("coverage", &DistanceBatch::coverage, "(n,) integers of Coverage.")
      .column("costs", &DistanceBatch::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &DistanceBatch::cost, "Cost of all poses together.")
      .entries();
  def_function(module, "distance", &query_distance, kDistanceDoc,
               with_limits({{"a"},
                            {"b"},
                            {"poses", py::none()},
                            {"at_most", py::float_(DistanceOptions{}.at_most), true}}));
}

}  // namespace soms::python
