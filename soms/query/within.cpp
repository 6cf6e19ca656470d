#include "soms/query/within.h"

#include "soms/base/arithmetic.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/near/near_query.h"

#include <algorithm>
#include <limits>

namespace soms {

namespace {

using detail::NearBatch;
using detail::NearEnd;
using detail::NearMemory;
using detail::PairFrame;
using detail::WithinGoal;

Within ask(PairFrame& frame, double clearance, const WithinOptions& options,
           const Parallel& parallel, NearMemory& memory) {
  WithinGoal goal(frame, clearance);
  const NearEnd end = detail::pursue(frame, goal, options.deadline, parallel, memory);
  Within answer;
  answer.cost = end.cost;
  answer.within = goal.triangles().has_value();
  if (answer.within) {
    answer.triangles = goal.triangles();
    const auto points = goal.found().points();
    answer.point_a = points[0];
    answer.point_b = points[1];
  } else {
    answer.coverage = end.complete ? Coverage::complete : Coverage::cut;
    answer.at_least = end.complete ? clearance : end.at_least;
  }
  return answer;
}

Within of_empty() {
  Within answer;
  answer.at_least = std::numeric_limits<double>::infinity();
  return answer;
}

void resize(WithinBatch& batch, std::size_t count) {
  batch.within.resize(count);
  batch.triangles.resize(count);
  batch.point_a.resize(count);
  batch.point_b.resize(count);
  batch.at_least.resize(count);
  batch.coverage.resize(count);
  batch.costs.resize(count);
}

void put(const Within& answer, std::size_t pose, WithinBatch& batch) {
  batch.within[pose] = answer.within ? 1 : 0;
  batch.triangles[pose] = answer.triangles;
  batch.point_a[pose] = answer.point_a;
  batch.point_b[pose] = answer.point_b;
  batch.at_least[pose] = answer.at_least;
  batch.coverage[pose] = answer.coverage;
  batch.costs[pose] = answer.cost;
}

void check_clearance(double clearance) {
  detail::check_length(clearance, "within: the clearance");
}

}  // namespace

Within within(const Body& a, const Body& b, double clearance, const WithinOptions& options,
              const Parallel& parallel) {
  const PlainArithmetic plain;
  check_clearance(clearance);
  detail::check_pose(a.pose, a.shape);
  detail::check_pose(b.pose, b.shape);
  check_stop(parallel);
  if (detail::is_empty(a.shape) || detail::is_empty(b.shape)) {
    return of_empty();
  }
  PairFrame frame(a, b);
  NearMemory memory;
  return ask(frame, clearance, options, parallel, memory);
}

Within WithinBatch::at(std::size_t pose) const {
  return {within[pose] != 0, triangles[pose], point_a[pose], point_b[pose],
          at_least[pose],    coverage[pose],  costs[pose]};
}

WithinBatch within(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                   double clearance, const WithinOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check_clearance(clearance);
  WithinBatch batch;
  resize(batch, poses.size());
  detail::check_pose(fixed.pose, fixed.shape);
  check_stop(parallel);
  const bool empty = detail::is_empty(mover) || detail::is_empty(fixed.shape);
  const Parallel alone = {.stop = parallel.stop};
  detail::for_each_pose(
      poses, mover, parallel, [&] { return NearBatch(mover, fixed); },
      [&](NearBatch& memory, const Pose& pose, std::size_t i) {
        put(empty ? of_empty()
                  : ask(memory.place(pose), clearance, options, alone, memory.memory()),
            i, batch);
      });
  for (const Cost& cost : batch.costs) {
    batch.cost += cost;
  }
  return batch;
}

}  // namespace soms
