#include "soms/query/distance.h"

#include "soms/base/arithmetic.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/near/near_query.h"
#include "soms/query/overlap.h"

#include <algorithm>

namespace soms {

namespace {

using detail::NearBatch;
using detail::NearEnd;
using detail::NearestGoal;
using detail::NearMemory;
using detail::PairDistance;
using detail::PairFrame;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void name_points(PairDistance& pair, Distance& answer) {
  const auto points = pair.points();
  answer.point_a = points[0];
  answer.point_b = points[1];
}

/// The bodies overlap at `found`: names the least pair that does.
void name_overlap(const Body& a, const Body& b, const DistanceOptions& options,
                  const Parallel& parallel, NearestGoal& found, Distance& answer) {
  // On one thread, so that the cost is the same for any number of them.
  const Overlap least = overlap(a, b, {.mode = OverlapMode::first, .deadline = options.deadline},
                                {.stop = parallel.stop});
  answer.distance = {0, 0};
  answer.cost += least.cost;
  answer.coverage = least.coverage == Coverage::cut ? Coverage::cut : Coverage::complete;
  answer.triangles = least.any ? least.pairs.front() : *found.triangles();
  PairDistance pair(detail::moved({&a.shape, &a.pose}, answer.triangles->first),
                    detail::moved({&b.shape, &b.pose}, answer.triangles->second));
  name_points(pair, answer);
}

/// Makes an answer of a traversal that found no overlap.
void name_nearest(const NearEnd& end, const DistanceOptions& options, NearestGoal& found,
                  Distance& answer) {
  answer.coverage = end.complete ? Coverage::complete : Coverage::cut;
  answer.distance = {end.at_least, kInfinity};
  if (found.triangles()) {
    answer.triangles = found.triangles();
    name_points(found.nearest(), answer);
    const Bracket nearest = found.nearest().distance();
    answer.distance = {end.complete ? nearest.lower : std::min(end.at_least, nearest.lower),
                       nearest.upper};
  } else if (end.complete) {
    answer.farther = true;
    answer.distance.lower = options.at_most;
  }
}

Distance ask(const Body& a, const Body& b, PairFrame& frame, const DistanceOptions& options,
             const Parallel& parallel, NearMemory& memory) {
  NearestGoal goal(frame, options.at_most);
  const NearEnd end = detail::pursue(frame, goal, options.deadline, parallel, memory);
  Distance answer;
  answer.cost = end.cost;
  if (goal.touching()) {
    name_overlap(a, b, options, parallel, goal, answer);
  } else {
    name_nearest(end, options, goal, answer);
  }
  return answer;
}

Distance of_empty() {
  Distance answer;
  answer.distance = {kInfinity, kInfinity};
  return answer;
}

void resize(DistanceBatch& batch, std::size_t count) {
  batch.lower.resize(count);
  batch.upper.resize(count);
  batch.triangles.resize(count);
  batch.point_a.resize(count);
  batch.point_b.resize(count);
  batch.farther.resize(count);
  batch.coverage.resize(count);
  batch.costs.resize(count);
}

void put(const Distance& answer, std::size_t pose, DistanceBatch& batch) {
  batch.lower[pose] = answer.distance.lower;
  batch.upper[pose] = answer.distance.upper;
  batch.triangles[pose] = answer.triangles;
  batch.point_a[pose] = answer.point_a;
  batch.point_b[pose] = answer.point_b;
  batch.farther[pose] = answer.farther ? 1 : 0;
  batch.coverage[pose] = answer.coverage;
  batch.costs[pose] = answer.cost;
}

}  // namespace

void check(const DistanceOptions& options) {
  detail::check_length(options.at_most, "distance options: at_most");
}

Distance distance(const Body& a, const Body& b, const DistanceOptions& options,
                  const Parallel& parallel) {
  const PlainArithmetic plain;
  check(options);
  detail::check_pose(a.pose, a.shape);
  detail::check_pose(b.pose, b.shape);
  check_stop(parallel);
  if (detail::is_empty(a.shape) || detail::is_empty(b.shape)) {
    return of_empty();
  }
  PairFrame frame(a, b);
  NearMemory memory;
  return ask(a, b, frame, options, parallel, memory);
}

Distance DistanceBatch::at(std::size_t pose) const {
  return {{lower[pose], upper[pose]}, triangles[pose], point_a[pose], point_b[pose],
          farther[pose] != 0,         coverage[pose],  costs[pose]};
}

DistanceBatch distance(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                       const DistanceOptions& options, const Parallel& parallel) {
  const PlainArithmetic plain;
  check(options);
  DistanceBatch batch;
  resize(batch, poses.size());
  detail::check_pose(fixed.pose, fixed.shape);
  check_stop(parallel);
  const bool empty = detail::is_empty(mover) || detail::is_empty(fixed.shape);
  const Parallel alone = {.stop = parallel.stop};
  detail::for_each_pose(
      poses, mover, parallel, [&] { return NearBatch(mover, fixed); },
      [&](NearBatch& memory, const Pose& pose, std::size_t i) {
        put(empty ? of_empty()
                  : ask(Body(mover, pose), fixed, memory.place(pose), options, alone,
                        memory.memory()),
            i, batch);
      });
  for (const Cost& cost : batch.costs) {
    batch.cost += cost;
  }
  return batch;
}

}  // namespace soms
