// The nearest of many bodies to points.
#include "soms/base/arithmetic.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/nearest_body.h"

#include <algorithm>
#include <limits>

namespace soms::detail {

namespace {

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// How far is a point from the surfaces?
class PointQuestion : public PointMeasure {
 public:
  using Answer = Closest;
  using Found = BodyClosest;

  PointQuestion(const Vec3& point, const ClosestOptions& options, LeftOut left_out,
                const Limits& limits)
      : PointMeasure(point, options, limits), left_out_(left_out) {}

  [[nodiscard]] Closest ask(const Body& body, std::uint32_t number, double limit) const {
    return number == left_out_ ? Closest() : nearest(body, limit);
  }

 private:
  LeftOut left_out_;
};

/// Some body that takes part has triangles.
bool any_triangles(BodySets sets, LeftOut left_out) {
  std::size_t filled = 0;
  for (const BodySet* set : sets) {
    filled += set->filled();
  }
  const bool all = !left_out || body_of(sets, *left_out).shape.bounds().empty();
  return filled > (all ? 0 : 1);
}

BodyClosest search(BodySets sets, const Vec3& point, const ClosestOptions& options,
                   LeftOut left_out, const Limits& limits, SearchMemory& memory) {
  const PointQuestion question(point, options, left_out, limits);
  NearestBody nearest(question);
  nearest.run(sets, memory);
  BodyClosest answer;
  if (nearest.found()) {
    answer = *nearest.found();
  } else {
    answer.farther = !nearest.cut() && any_triangles(sets, left_out);
    answer.distance = {answer.farther ? options.at_most : kBeyondAll, kBeyondAll};
  }
  answer.coverage = Coverage::complete;
  if (nearest.cut()) {
    answer.coverage = Coverage::cut;
    answer.distance.lower = std::min(answer.distance.lower, nearest.at_least());
  }
  answer.cost = nearest.cost();
  return answer;
}

}  // namespace

BodyClosest closest(BodySets sets, const Vec3& point, const ClosestOptions& options,
                    LeftOut left_out, const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, left_out);
  static_cast<void>(soms::closest(Body(), point, options, limits));  // all but checks
  SearchMemory memory;
  return search(sets, point, options, left_out, limits, memory);
}

BodyClosestBatch closest(BodySets sets, std::span<const Vec3> points, const ClosestOptions& options,
                         LeftOut left_out, const Limits& limits) {
  const PlainArithmetic plain;
  check_left_out(sets, left_out);
  // The batch of a body without triangles: checked, and columns of the right size.
  BodyClosestBatch batch{soms::closest(Body(), points, options, limits), {}};
  batch.body.resize(points.size());
  const Limits alone = limits.alone();
  for_each_block(
      points.size(), limits, [] { return SearchMemory(); },
      [&](SearchMemory& memory, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          put_columns(search(sets, points[i], options, left_out, alone, memory), i, batch);
        }
      });
  sum_costs<BodyClosest>(batch);
  return batch;
}

}  // namespace soms::detail
