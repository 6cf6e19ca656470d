#include "soms/query/winding.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/describe/columns.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/query/detail/near/point_query.h"
#include "soms/query/detail/parity/crossing_batch.h"
#include "soms/query/detail/winding/winding_tree.h"

#include <limits>
#include <utility>

namespace soms {

namespace {

using detail::Limit;
using detail::ParityFrame;
using detail::PointCrossings;
using detail::WindingTree;

constexpr Bracket kAllNumbers{-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};

void check_width(double width) {
  if (!(width >= 0 && width <= 1)) {
    throw Error(ErrorKind::usage, "WindingOptions::width must be 0 to 1",
                "the default, 1e-9, suits most");
  }
}

Side side_of(const Bracket& number, bool on) {
  if (on) {
    return Side::on;
  }
  return number.lower > 0.5 ? Side::inside : number.upper < 0.5 ? Side::outside : Side::undecided;
}

}  // namespace

WindingIndex::WindingIndex(Body body, const Limits& limits) : body_(std::move(body)) {
  const PlainArithmetic plain;
  detail::check_pose(body_.pose, body_.shape);
  check(limits);
  tree_ = std::make_shared<const WindingTree>(body_, limits);
}

std::uint64_t WindingIndex::boundary_edges() const {
  return tree_->boundary_edges();
}

std::size_t WindingIndex::memory() const {
  return tree_->memory();
}

const WindingTree& detail::tree_of(const WindingIndex& index) {
  return *index.tree_;
}

Winding winding(const WindingIndex& index, const Vec3& point, const WindingOptions& options,
                const Limits& limits) {
  detail::check_point(point);
  return winding(index, std::span(&point, 1), options, limits).at(0);
}

Winding WindingBatch::at(std::size_t point) const {
  return row_of<Winding>(*this, point);
}

WindingBatch winding(const WindingIndex& index, std::span<const Vec3> points,
                     const WindingOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  check_width(options.width);
  detail::check_points(points);
  WindingBatch answer;
  resize_columns<Winding>(answer, points.size());
  const bool empty = detail::is_empty(index.body().shape);
  const Winding first = empty ? Winding{.side = Side::outside}
                              : Winding{.number = kAllNumbers, .coverage = Coverage::cut};
  for (std::size_t i = 0; i < points.size(); ++i) {
    put_columns(first, i, answer);
  }
  if (empty) {
    return answer;
  }
  const Body& body = index.body();
  const WindingTree& tree = detail::tree_of(index);
  const ParityFrame frame(body.shape.layout(), body.pose);
  detail::for_each_crossing<WindingTree::Memory>(
      body, frame, points, answer.costs, limits,
      [&](WindingTree::Memory& memory, std::size_t i, const PointCrossings& met, Limit& limit) {
        const bool forward = frame.start(points[i]).sign > 0;
        Cost cost;
        const Bracket number =
            tree.number(body, points[i], frame.axis(), forward, met, options.width, memory, cost);
        answer.lower[i] = number.lower;
        answer.upper[i] = number.upper;
        answer.side[i] = side_of(number, !met.on.empty());
        answer.coverage[i] = Coverage::complete;
        answer.costs[i] += cost;
        static_cast<void>(limit.spend(1 + cost.triangle_tests + cost.node_tests));
      });
  sum_costs<Winding>(answer);
  return answer;
}

}  // namespace soms
