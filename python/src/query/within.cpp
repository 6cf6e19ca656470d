#include "soms/query/within.h"

#include "soms/query/print.h"

#include "python/src/answer.h"
#include "python/src/bind.h"
#include "python/src/function.h"
#include "python/src/query/pose_query.h"

#include <optional>

namespace soms::python {

namespace {

constexpr const char* kWithinDoc =
    R"(within(a, b, clearance, poses=None, *, seconds=None, threads=1, progress=None)

Are two surfaces at most a clearance apart? Decided exactly, and sooner than their distance is known.

a, b, poses, seconds, threads, progress: as for overlap. clearance: a number from 0 on; 0 asks for
overlap.

Returns Within, or with poses WithinBatch. Raises Error as overlap does.
Cost: at most that of distance.)";

py::object query_within(const py::object& a, const py::object& b, double clearance,
                        const py::object& poses, std::optional<double> seconds, int threads,
                        const py::object& progress) {
  const WithinOptions options{.deadline = deadline_in(seconds)};
  return answer_poses_or_tiles(a, b, poses, threads, progress,
                               [&](const Parallel& parallel, const auto&... bodies) {
                                 return within(bodies..., clearance, options, parallel);
                               });
}

}  // namespace

void bind_within(py::module_& module) {
  AnswerClass<Within> one(module, "Within", "Answer of within. Its truth is that of within.");
  one.truth("within", &Within::within, "The distance is at most the clearance.")
      .field("triangles", &Within::triangles, "Some pair within the clearance, or None.")
      .field("point_a", &Within::point_a, "(3,): the end of its shortest segment on a, in world.")
      .field("point_b", &Within::point_b, "(3,): the other end, on b.")
      .field("at_least", &Within::at_least, "A lower bound of the distance.")
      .field("coverage", &Within::coverage, "Coverage.")
      .field("cost", &Within::cost, "Cost.");
  AnswerClass<WithinBatch> batch(module, "WithinBatch", "Answers of within for n poses.");
  batch.column("within", &WithinBatch::within, "(n,) bool.")
      .column("triangles", &WithinBatch::triangles, "(n, 2) int64, -1 where there is no pair.")
      .column("point_a", &WithinBatch::point_a, "(n, 3) float64; 0 where there is no pair.")
      .column("point_b", &WithinBatch::point_b, "(n, 3) float64; 0 where there is no pair.")
      .column("at_least", &WithinBatch::at_least, "(n,) float64.")
      .column("coverage", &WithinBatch::coverage, "(n,) integers of Coverage.")
      .column("costs", &WithinBatch::costs, "(n,) node_tests, triangle_tests, exact_tests.")
      .field("cost", &WithinBatch::cost, "Cost of all poses together.")
      .entries();
  def_function(module, "within", &query_within, kWithinDoc,
               with_limits({{"a"}, {"b"}, {"clearance"}, {"poses", py::none()}}));
}

}  // namespace soms::python
