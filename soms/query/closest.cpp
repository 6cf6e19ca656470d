#include "soms/query/closest.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/near/point_query.h"

#include <algorithm>

namespace soms {

namespace {

using detail::ClosestGoal;
using detail::kInfinity;
using detail::NearEnd;
using detail::NearTriangle;
using detail::PointFrame;
using detail::PointMemory;
using detail::PointToTriangle;

Closest ask(const PointFrame& frame, const Vec3& point, const ClosestOptions& options,
            const Limits& limits, PointMemory& memory) {
  ClosestGoal goal(frame, point, options.at_most);
  const NearEnd end = detail::pursue(frame, point, goal, limits, memory);
  Closest answer;
  answer.cost = end.cost;
  answer.coverage = end.complete ? Coverage::complete : Coverage::cut;
  answer.distance = {end.at_least, kInfinity};
  if (goal.found()) {
    PointToTriangle& pair = goal.found()->pair;
    const std::uint64_t before = pair.exact_tests();
    const Bracket nearest = pair.distance();
    answer.triangle = goal.found()->id;
    answer.point = pair.nearest();
    answer.feature = pair.feature();
    answer.distance = {end.complete ? nearest.lower : std::min(end.at_least, nearest.lower),
                       nearest.upper};
    answer.cost.exact_tests += pair.exact_tests() - before;
  } else if (end.complete) {
    answer.farther = true;
    answer.distance.lower = options.at_most;
  }
  return answer;
}

Closest of_empty() {
  return {.distance = {kInfinity, kInfinity}};
}

}  // namespace

void detail::check_options(const ClosestOptions& options) {
  detail::check_length(options.at_most, "closest options: at_most");
}

Closest closest(const Body& body, const Vec3& point, const ClosestOptions& options,
                const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  detail::check_pose(body.pose, body.shape);
  detail::check_point(point);
  check_stop(limits);
  if (detail::is_empty(body.shape)) {
    return of_empty();
  }
  PointMemory memory;
  return ask(PointFrame(body), point, options, limits, memory);
}

Closest ClosestBatch::at(std::size_t i) const {
  return row_of<Closest>(*this, i);
}

ClosestBatch closest(const Body& body, std::span<const Vec3> points, const ClosestOptions& options,
                     const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  detail::check_pose(body.pose, body.shape);
  detail::check_points(points);
  check_stop(limits);
  ClosestBatch batch;
  resize_columns<Closest>(batch, points.size());
  if (detail::is_empty(body.shape)) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      put_columns(of_empty(), i, batch);
    }
    return batch;
  }
  const PointFrame frame(body);
  const std::vector<std::uint32_t> order = detail::order_of(points, body.shape);
  const Limits alone = limits.alone();
  detail::for_each_block(
      points.size(), limits, [] { return PointMemory(); },
      [&](PointMemory& memory, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const std::size_t i = order.empty() ? k : order[k];
          put_columns(ask(frame, points[i], options, alone, memory), i, batch);
        }
      });
  sum_costs<Closest>(batch);
  return batch;
}

}  // namespace soms
