#include "soms/query/overlap.h"

#include "soms/query/print.h"

#include "python/src/call.h"
#include "python/src/described.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <cstdint>
#include <optional>

namespace soms::python {

namespace {

constexpr const char* kOverlapDoc =
    R"(overlap(a, b, poses=None, *, mode='all', limit=None, timeout=None, threads=1, progress=None)

Which triangles of a and b share a point? Decided exactly; touching counts. Surfaces only: a body
wholly inside another touches nothing (see solid).

a, b: Body, Shape or Mesh; b may be a TileSet. poses: poses of a in place of its own, (n, 3, 4), (n, 4, 4), (n, 7) as
x y z qw qx qy qz, (n, 3), or a list of Pose. mode: 'all' pairs, 'any' one, or 'first', the least.
limit: most pairs, for each pose. timeout: seconds after which the call ends, with coverage 'cut'.
threads: 0 for all processors. progress: called with the share done.

Returns Overlap, or with poses OverlapBatch: the answers of single calls. Raises Error of kind
not_rigid, not_finite, out_of_range (poses, named by index), usage.
Cost: typically logarithmic in the triangles, linear in the answer.)";

py::object query_overlap(const py::object& a, const py::object& b, const py::object& poses,
                         const py::object& mode, std::optional<std::uint64_t> limit,
                         std::optional<double> timeout, int threads, const py::object& progress) {
  OverlapOptions options{.mode = enum_of<OverlapMode>(mode, "mode")};
  if (limit) {
    options.limit = *limit;
  }
  return answer_poses_or_tiles(a, b, poses, {threads, timeout}, progress,
                               [&](const Limits& limits, const auto&... bodies) {
                                 return overlap(bodies..., options, limits);
                               });
}

}  // namespace

void bind_overlap(py::module_& module) {
  bind_answer<Overlap>(module).def("hash", &Overlap::hash,
                                   "hash() -> int\n\nFNV-1a 64 over the pairs.");
  bind_answer<OverlapBatch>(module);
  def_function(module, "overlap", &query_overlap, kOverlapDoc,
               with_limits({{"a"},
                            {"b"},
                            {"poses", py::none()},
                            {"mode", py::str("all"), true},
                            {"limit", py::none(), true}}));
}

}  // namespace soms::python
