#include "soms/query/distance.h"

#include "soms/query/print.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kDistanceDoc =
    R"(distance(a, b, poses=None, *, at_most=inf, timeout=None, threads=1, progress=None)

The least distance of two surfaces: 0 exactly where they overlap. A body wholly inside another has a
distance above 0 from it.

a, b, poses, timeout, threads, progress: as for overlap. at_most: beyond this the answer is farther,
and sooner.

Returns Distance, or with poses DistanceBatch. The least distance is from lower to upper, which are
equal doubles or neighbors. Raises Error as overlap does.
Cost: typically logarithmic in the triangles.
Source: Larsen, Gottschalk, Lin and Manocha 2000.)";

py::object query_distance(const py::object& a, const py::object& b, const py::object& poses,
                          double at_most, std::optional<double> timeout, int threads,
                          const py::object& progress) {
  const DistanceOptions options{.at_most = at_most};
  return answer_poses_or_tiles(a, b, poses, {threads, timeout}, progress,
                               [&](const Limits& limits, const auto&... bodies) {
                                 return distance(bodies..., options, limits);
                               });
}

}  // namespace

void bind_distance(py::module_& module) {
  bind_answers_of<Distance>(module);
  def_function(module, "distance", &query_distance, kDistanceDoc,
               with_limits({{"a"},
                            {"b"},
                            {"poses", py::none()},
                            {"at_most", py::float_(DistanceOptions{}.at_most), true}}));
}

}  // namespace soms::python
