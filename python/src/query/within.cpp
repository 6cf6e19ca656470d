#include "soms/query/within.h"

#include "soms/query/print.h"

#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kWithinDoc =
    R"(within(a, b, clearance, poses=None, *, timeout=None, threads=1, progress=None)

Are two surfaces at most a clearance apart? Decided exactly, and sooner than their distance is known.

a, b, poses, timeout, threads, progress: as for overlap. clearance: a number from 0 on; 0 asks for
overlap.

Returns Within, or with poses WithinBatch. Raises Error as overlap does.
Cost: at most that of distance.)";

py::object query_within(const py::object& a, const py::object& b, double clearance,
                        const py::object& poses, std::optional<double> timeout, int threads,
                        const py::object& progress) {
  return answer_poses_or_tiles(a, b, poses, {threads, timeout}, progress,
                               [&](const Limits& limits, const auto&... bodies) {
                                 return within(bodies..., clearance, limits);
                               });
}

}  // namespace

void bind_within(py::module_& module) {
  bind_answers_of<Within>(module);
  def_function(module, "within", &query_within, kWithinDoc,
               with_limits({{"a"}, {"b"}, {"clearance"}, {"poses", py::none()}}));
}

}  // namespace soms::python
