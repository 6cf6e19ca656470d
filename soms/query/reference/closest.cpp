#include "soms/query/reference/closest.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/detail/moved_triangles.h"
#include "soms/query/reference/detail/rounded_squares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace soms::reference {

namespace {

using detail::kInfinity;
using detail::kRoundedUp;
using detail::kUnderflown;
using detail::square;
using soms::detail::ExactPoint;
using soms::detail::SquaredDistance;

/// Not above the square of the distance of the triangle's box, but for rounding.
double box_gap(const Triangle& t, const Vec3& point) {
  const Box box = bounds(t);
  Vec3 gap;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gap[axis] = std::max({0.0, point[axis] - box.upper[axis], box.lower[axis] - point[axis]});
  }
  return square(gap);
}

TriangleFeature feature_of(const ExactPoint& exact) {
  switch (soms::detail::corner_count(exact.feature())) {
    case 1:
      return TriangleFeature::vertex;
    case 2:
      return TriangleFeature::edge;
    default:
      return TriangleFeature::face;
  }
}

/// The features of nothing are guessed: each is tried in turn.
constexpr soms::detail::Feature kNoGuess = 1;

void check_coordinates(const Vec3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(point[axis])) {
      throw Error(ErrorKind::not_finite, "point: a coordinate is not a finite number", "");
    }
    if (std::abs(point[axis]) > kMaxCoordinate) {
      throw Error(ErrorKind::out_of_range, "point: a coordinate exceeds 2^300", "");
    }
  }
}

}  // namespace

Closest closest_by_brute_force(const Body& body, const Vec3& point) {
  const PlainArithmetic plain;
  check_coordinates(point);
  const std::vector<Triangle> triangles = detail::moved_triangles(body.shape.mesh(), body.pose);
  Closest answer;
  answer.distance = {kInfinity, kInfinity};
  double bound = kInfinity;
  for (const Triangle& t : triangles) {
    bound = std::min({bound, square(t.a - point), square(t.b - point), square(t.c - point)});
  }
  bound = bound * kRoundedUp + kUnderflown;
  std::optional<ExactPoint> best;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    ++answer.cost.node_tests;
    if (box_gap(triangles[i], point) > bound * kRoundedUp + kUnderflown) {
      continue;
    }
    ++answer.cost.triangle_tests;
    ++answer.cost.exact_tests;
    ExactPoint here(point, triangles[i], kNoGuess);
    if (!best || compare(here.squared(), best->squared()) < 0) {
      best.emplace(std::move(here));
      answer.triangle = static_cast<TriangleId>(i);
    }
  }
  if (best) {
    answer.distance = bracket(best->squared());
    answer.point = best->nearest();
    answer.feature = feature_of(*best);
  }
  return answer;
}

SignedClosest closest_by_brute_force(const ClosedBody& body, const Vec3& point) {
  return {closest_by_brute_force(body.body(), point), contains_by_brute_force(body.body(), point)};
}

std::vector<RankedTriangle> triangles_by_brute_force(const Body& body, const Vec3& point,
                                                     double at_most) {
  const PlainArithmetic plain;
  check_coordinates(point);
  if (!(at_most >= 0)) {
    throw Error(ErrorKind::usage, "near triangles: the radius is negative or not a number", "");
  }
  const std::vector<Triangle> triangles = detail::moved_triangles(body.shape.mesh(), body.pose);
  std::vector<std::pair<SquaredDistance, TriangleId>> found;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    SquaredDistance squared = ExactPoint(point, triangles[i], kNoGuess).squared();
    if (compare(squared, at_most) <= 0) {
      found.emplace_back(std::move(squared), static_cast<TriangleId>(i));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return compare(a.first, b.first) < 0; });
  std::vector<RankedTriangle> ranked;
  for (const auto& [squared, id] : found) {
    ranked.push_back({id, bracket(squared)});
  }
  return ranked;
}

}  // namespace soms::reference
