#include "soms/query/signed_closest.h"

#include "soms/base/arithmetic.h"

namespace soms {

namespace {

/// A distance of 0 says on which side the point is, even if time ran out before it was counted.
Side side_of(Side counted, const Bracket& distance) {
  return distance.upper == 0 ? Side::on : counted;
}

}  // namespace

Bracket SignedClosest::distance() const {
  const auto& [lower, upper] = closest.distance;
  switch (side) {
    case Side::outside:
      return closest.distance;
    case Side::inside:
      return {-upper, -lower};
    case Side::on:
      return {0, 0};
    case Side::undecided:
      break;
  }
  return {-upper, upper};
}

SignedClosest closest(const ClosedBody& body, const Vec3& point, const ClosestOptions& options,
                      const Limits& limits) {
  const PlainArithmetic plain;  // flushed to 0, a tiny distance would be `on`
  SignedClosest answer{closest(body.body(), point, options, limits)};
  const Contains found = contains(body, point, limits);
  answer.closest.cost += found.cost;
  answer.side = side_of(found.side, answer.closest.distance);
  return answer;
}

SignedClosest SignedClosestBatch::at(std::size_t point) const {
  return {closest.at(point), side[point]};
}

SignedClosestBatch closest(const ClosedBody& body, std::span<const Vec3> points,
                           const ClosestOptions& options, const Limits& limits) {
  const PlainArithmetic plain;
  SignedClosestBatch batch{closest(body.body(), points, options, limits), {}};
  const ContainsBatch found = contains(body, points, limits);
  for (std::size_t i = 0; i < points.size(); ++i) {
    batch.closest.costs[i] += found.costs[i];
    batch.side.push_back(side_of(found.side[i], {batch.closest.lower[i], batch.closest.upper[i]}));
  }
  batch.closest.cost += found.cost;
  return batch;
}

}  // namespace soms
