#include "soms/query/overlap.h"

#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/bind.h"
#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <cstdint>
#include <optional>

namespace soms::python {

namespace {

constexpr const char* kOverlapDoc =
    R"(overlap(a, b, poses=None, *, mode='all', limit=None, seconds=None, threads=1, progress=None)

Which triangles of a and b share a point? Decided exactly; touching counts. Surfaces only: a body
wholly inside another touches nothing (see solid).

a, b: Body, Shape or Mesh; b may be a TileSet. poses: poses of a in place of its own, (n, 3, 4), (n, 4, 4), (n, 7) as
x y z qw qx qy qz, (n, 3), or a list of Pose. mode: 'all' pairs, 'any' one, or 'first', the least.
limit: most pairs, for each pose. seconds: ends the call, with coverage 'cut', after that time.
threads: 0 for all processors. progress: called with the share done.

Returns Overlap, or with poses OverlapBatch: the answers of single calls. Raises Error of kind
not_rigid, not_finite, out_of_range (poses, named by index), usage.
Cost: typically logarithmic in the triangles, linear in the answer.)";

py::object query_overlap(const py::object& a, const py::object& b, const py::object& poses,
                         const py::object& mode, std::optional<std::uint64_t> limit,
                         std::optional<double> seconds, int threads, const py::object& progress) {
  OverlapOptions options{.mode = enum_of<OverlapMode>(mode, "mode"),
                         .deadline = deadline_in(seconds)};
  if (limit) {
    options.limit = *limit;
  }
  check(options);
  return answer_poses_or_tiles(a, b, poses, threads, progress,
                               [&](const Parallel& parallel, const auto&... bodies) {
                                 return overlap(bodies..., options, parallel);
                               });
}

}  // namespace

void bind_overlap(py::module_& module) {
  AnswerClass<Overlap> one(module, "Overlap", "Answer of overlap. Its truth is that of any.");
  one.truth("any", &Overlap::any, "Some pair of triangles shares a point.")
      .column("pairs", &Overlap::pairs,
              "(n, 2) uint32: triangle of a, triangle of b; sorted. One pair in modes any, first.")
      .field("coverage", &Overlap::coverage, "Coverage.")
      .field("cost", &Overlap::cost, "Cost.");
  one.def("hash", &Overlap::hash, "hash() -> int\n\nFNV-1a 64 over the pairs.");
  AnswerClass<OverlapBatch> batch(module, "OverlapBatch", "Answers of overlap for n poses.");
  batch.column("any", &OverlapBatch::any, "(n,) bool.")
      .rows("pairs", &OverlapBatch::offsets, &OverlapBatch::pairs,
            "(k, 2) uint32: the pairs of all poses; those of pose i are of(i).")
      .column("offsets", &OverlapBatch::offsets,
              "(n + 1,) uint64: pose i has pairs[offsets[i]:offsets[i + 1]].")
      .column("coverage", &OverlapBatch::coverage, "(n,) integers of Coverage.")
      .column("costs", &OverlapBatch::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &OverlapBatch::cost, "Cost of all poses together.")
      .entries();
  def_function(module, "overlap", &query_overlap, kOverlapDoc,
               with_limits({{"a"},
                            {"b"},
                            {"poses", py::none()},
                            {"mode", py::str("all"), true},
                            {"limit", py::none(), true}}));
}

}  // namespace soms::python
