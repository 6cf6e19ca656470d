#include "soms/query/distance.h"

#include "soms/base/arithmetic.h"
#include "soms/base/double_limits.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/near/near_question.h"
#include "soms/query/detail/overlap_query.h"

#include <algorithm>

namespace soms {

namespace {

using detail::kInfinity;
using detail::NearEnd;
using detail::NearestGoal;
using detail::NearMemory;
using detail::PairDistance;
using detail::PairFrame;

void name_points(PairDistance& pair, Distance& answer) {
  const auto points = pair.points();
  answer.point_a = points[0];
  answer.point_b = points[1];
}

/// The bodies overlap at `found`: names the least pair that does.
void name_overlap(const Body& a, const Body& b, PairFrame& frame, const Limits& limits,
                  NearestGoal& found, Distance& answer) {
  const detail::LeastOverlap least = detail::least_overlap(frame, *found.triangles(), limits);
  answer.distance = {0, 0};
  answer.cost += least.cost;
  answer.coverage = least.late ? Coverage::cut : Coverage::complete;
  answer.triangles = least.triangles;
  PairDistance pair(detail::moved({&a.shape, &a.pose}, answer.triangles->a),
                    detail::moved({&b.shape, &b.pose}, answer.triangles->b));
  name_points(pair, answer);
}

/// Makes an answer of a traversal that found no overlap.
void name_nearest(const NearEnd& end, const DistanceOptions& options, NearestGoal& found,
                  Distance& answer) {
  answer.coverage = end.complete ? Coverage::complete : Coverage::cut;
  answer.distance = {end.at_least, kInfinity};
  if (found.triangles()) {
    answer.triangles = found.triangles();
    const Bracket nearest = found.nearest().distance();
    name_points(found.nearest(), answer);  // which profits from what the distance needed
    answer.distance = {end.complete ? nearest.lower : std::min(end.at_least, nearest.lower),
                       nearest.upper};
  } else if (end.complete) {
    answer.farther = true;
    answer.distance.lower = options.at_most;
  }
}

/// How far apart?
class DistanceQuery {
 public:
  explicit DistanceQuery(const DistanceOptions& options) : options_(options) {}

  [[nodiscard]] Distance ask(const Body& a, const Body& b, PairFrame& frame, const Limits& limits,
                             NearMemory& memory) const {
    NearestGoal goal(frame, options_.at_most);
    const NearEnd end = detail::pursue(frame, goal, limits, memory);
    Distance answer;
    answer.cost = end.cost;
    if (goal.touching()) {
      name_overlap(a, b, frame, limits, goal, answer);
    } else {
      name_nearest(end, options_, goal, answer);
    }
    return answer;
  }

  [[nodiscard]] Distance of_empty() const { return {.distance = {kInfinity, kInfinity}}; }

 private:
  DistanceOptions options_;
};

}  // namespace

void detail::check_options(const DistanceOptions& options) {
  detail::check_length(options.at_most, "distance options: at_most");
}

Distance distance(const Body& a, const Body& b, const DistanceOptions& options,
                  const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  return detail::ask_near(DistanceQuery(options), a, b, limits);
}

Distance DistanceBatch::at(std::size_t pose) const {
  return row_of<Distance>(*this, pose);
}

DistanceBatch distance(const Shape& mover, std::span<const Pose> poses, const Body& fixed,
                       const DistanceOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_options(options);
  return detail::ask_near_batch<Distance>(DistanceQuery(options), mover, poses, fixed, limits);
}

}  // namespace soms
