#include "soms/base/arithmetic.h"
#include "soms/query/closest.h"
#include "soms/query/detail/check_options.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/near/point_query.h"

#include <algorithm>
#include <limits>

namespace soms {

namespace {

using detail::Limit;
using detail::NearEnd;
using detail::NearTriangle;
using detail::PointFrame;
using detail::PointMemory;
using detail::SeveralGoal;

/// A triangle of a row.
struct RowEntry {
  TriangleId id;
  Bracket distance;
};

/// The rows of a block of points, in the order in which they were answered.
struct RowBlock {
  std::vector<std::size_t> ends;
  std::vector<RowEntry> entries;
};

/// Answers points into blocks, then puts the rows into their places.
class Rows {
 public:
  Rows(const Body& body, std::span<const Vec3> points, std::size_t most,
       const ClosestOptions& options)
      : frame_(body),
        points_(points),
        most_(most),
        options_(options),
        order_(detail::order_of(points, body.shape)),
        blocks_((points.size() + detail::kPosesOfBlock - 1) / detail::kPosesOfBlock) {}

  void answer(NearTriangles& batch, const Limits& limits) {
    const Limits alone = limits.alone();
    detail::for_each_block(
        points_.size(), limits, [] { return PointMemory(); },
        [&](PointMemory& memory, std::size_t begin, std::size_t end) {
          RowBlock& block = blocks_[begin / detail::kPosesOfBlock];
          for (std::size_t k = begin; k < end; ++k) {
            ask(row_at(k), alone, memory, block, batch);
          }
        });
    gather(batch);
  }

 private:
  /// The row of the point that is answered at turn k.
  [[nodiscard]] std::size_t row_at(std::size_t k) const { return order_.empty() ? k : order_[k]; }

  void ask(std::size_t row, const Limits& limits, PointMemory& memory, RowBlock& block,
           NearTriangles& batch) const {
    SeveralGoal goal(frame_, points_[row], most_, options_.at_most);
    const NearEnd end = detail::pursue(frame_, points_[row], goal, limits, memory);
    Cost cost = end.cost;
    Limit limit(limits);
    for (const std::size_t i : goal.sorted(limit, cost)) {
      NearTriangle& found = goal.found()[i];
      const std::uint64_t before = found.pair.exact_tests();
      const bool late = limit.spend(1);
      block.entries.push_back({found.id, late ? found.pair.bounds() : found.pair.distance()});
      cost.exact_tests += found.pair.exact_tests() - before;
    }
    block.ends.push_back(block.entries.size());
    batch.coverage[row] = end.complete && !limit.late() ? Coverage::complete : Coverage::cut;
    batch.costs[row] = cost;
  }

  void gather(NearTriangles& batch) {
    visit([&](std::size_t row, const RowBlock&, std::size_t begin, std::size_t end) {
      batch.offsets[row + 1] = end - begin;
    });
    for (std::size_t row = 0; row < points_.size(); ++row) {
      batch.offsets[row + 1] += batch.offsets[row];
    }
    batch.triangle.resize(batch.offsets.back());
    batch.lower.resize(batch.offsets.back());
    batch.upper.resize(batch.offsets.back());
    visit([&](std::size_t row, const RowBlock& block, std::size_t begin, std::size_t end) {
      std::size_t to = batch.offsets[row];
      for (std::size_t i = begin; i < end; ++i, ++to) {
        batch.triangle[to] = block.entries[i].id;
        batch.lower[to] = block.entries[i].distance.lower;
        batch.upper[to] = block.entries[i].distance.upper;
      }
    });
  }

  /// Calls `take(row, block, begin, end)` for the entries of each row.
  template <class Take>
  void visit(const Take& take) const {
    std::size_t k = 0;
    for (const RowBlock& block : blocks_) {
      std::size_t begin = 0;
      for (const std::size_t end : block.ends) {
        take(row_at(k++), block, begin, end);
        begin = end;
      }
    }
  }

  PointFrame frame_;
  std::span<const Vec3> points_;
  std::size_t most_;
  ClosestOptions options_;
  std::vector<std::uint32_t> order_;
  std::vector<RowBlock> blocks_;
};

NearTriangles answer(const Body& body, std::span<const Vec3> points, std::size_t most,
                     const ClosestOptions& options, const Limits& limits) {
  detail::check_options(options);
  detail::check_pose(body.pose, body.shape);
  detail::check_points(points);
  check_stop(limits);
  NearTriangles batch;
  batch.offsets.assign(points.size() + 1, 0);
  batch.coverage.resize(points.size());
  batch.costs.resize(points.size());
  if (!detail::is_empty(body.shape) && most != 0) {
    Rows(body, points, most, options).answer(batch, limits);
  }
  batch.cost = detail::sum_of(batch.costs);
  return batch;
}

}  // namespace

NearTriangles nearest_triangles(const Body& body, std::span<const Vec3> points, std::size_t count,
                                const ClosestOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  return answer(body, points, count, options, limits);
}

NearTriangles near_triangles(const Body& body, std::span<const Vec3> points, double radius,
                             const ClosestOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  detail::check_length(radius, "near triangles: the radius");
  ClosestOptions within = options;
  detail::check_options(within);
  within.at_most = std::min(radius, options.at_most);
  return answer(body, points, std::numeric_limits<std::size_t>::max(), within, limits);
}

}  // namespace soms
