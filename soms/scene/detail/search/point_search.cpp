// The nearest of many bodies to points.
#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/point_to_triangle.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/scene/detail/box_bounds.h"
#include "soms/scene/detail/search/body_search.h"
#include "soms/scene/detail/search/nearest_body.h"

#include <algorithm>
#include <compare>
#include <limits>

namespace soms::detail {

namespace {

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// How far is a point from the surfaces?
class PointQuestion {
 public:
  using Answer = Closest;
  using Found = BodyClosest;

  PointQuestion(const Vec3& point, const ClosestOptions& options, LeftOut left_out,
                const Parallel& parallel)
      : point_(point), options_(options), left_out_(left_out), parallel_(parallel) {}

  [[nodiscard]] static const Bracket& measure(const Closest& answer) { return answer.distance; }

  [[nodiscard]] double key(const Box& box) const { return distance_at_least(point_, box); }

  [[nodiscard]] double limit() const { return options_.at_most; }

  [[nodiscard]] Closest ask(const Body& body, std::uint32_t number, double limit) const {
    if (number == left_out_) {
      return {};
    }
    Closest answer = soms::closest(body, point_, {limit, options_.deadline}, parallel_);
    if (answer.coverage == Coverage::cut && answer.triangle) {
      // What was proved of the body is not what is measured.
      answer.distance = point_distance(point_, moved_triangle(body, *answer.triangle)).distance;
    }
    return answer;
  }

  [[nodiscard]] std::strong_ordering compare(const Body& body, TriangleId triangle,
                                             const Body& other, TriangleId others) const {
    PointToTriangle here(point_, moved_triangle(body, triangle));
    PointToTriangle there(point_, moved_triangle(other, others));
    return here.compare(there);
  }

 private:
  const Vec3& point_;
  const ClosestOptions& options_;
  LeftOut left_out_;
  const Parallel& parallel_;
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
                   LeftOut left_out, const Parallel& parallel, SearchMemory& memory) {
  const PointQuestion question(point, options, left_out, parallel);
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

void put(const BodyClosest& answer, std::size_t i, BodyClosestBatch& batch) {
  batch.lower[i] = answer.distance.lower;
  batch.upper[i] = answer.distance.upper;
  batch.triangle[i] = answer.triangle;
  batch.point[i] = answer.point;
  batch.feature[i] = answer.feature;
  batch.farther[i] = answer.farther ? 1 : 0;
  batch.coverage[i] = answer.coverage;
  batch.costs[i] = answer.cost;
  batch.body[i] = answer.body;
}

}  // namespace

BodyClosest closest(BodySets sets, const Vec3& point, const ClosestOptions& options,
                    LeftOut left_out, const Parallel& parallel) {
  const PlainArithmetic plain;
  check_left_out(sets, left_out);
  static_cast<void>(soms::closest(Body(), point, options, parallel));  // all but checks
  SearchMemory memory;
  return search(sets, point, options, left_out, parallel, memory);
}

BodyClosestBatch closest(BodySets sets, std::span<const Vec3> points, const ClosestOptions& options,
                         LeftOut left_out, const Parallel& parallel) {
  const PlainArithmetic plain;
  check_left_out(sets, left_out);
  // The batch of a body without triangles: checked, and columns of the right size.
  BodyClosestBatch batch{soms::closest(Body(), points, options, parallel), {}};
  batch.body.resize(points.size());
  const Parallel alone = {.stop = parallel.stop};
  for_each_block(
      points.size(), parallel, [] { return SearchMemory(); },
      [&](SearchMemory& memory, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          put(search(sets, points[i], options, left_out, alone, memory), i, batch);
        }
      });
  batch.cost = sum_of(batch.costs);
  return batch;
}

}  // namespace soms::detail
