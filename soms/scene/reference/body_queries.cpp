#include "soms/scene/reference/body_queries.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact_point.h"
#include "soms/geometry/detail/exact_ray.h"
#include "soms/query/reference/closest.h"
#include "soms/query/reference/ray.h"
#include "soms/scene/detail/body_search.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace soms::reference {

namespace {

using soms::detail::ExactRay;
using soms::detail::RayLine;
using soms::detail::triangle_of;

template <class Line>
BodyHit first_hit(std::span<const Body> bodies, const Line& line, const RayLine& exact_line) {
  const PlainArithmetic plain;
  BodyHit first;
  std::optional<soms::detail::RayTime> least;
  Cost cost;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const ClosestHit here = closest_hit_by_brute_force(bodies[k], line);
    cost += here.cost;
    if (!here.triangle) {
      continue;
    }
    const ExactRay exact(exact_line, triangle_of(bodies[k], *here.triangle));
    if (!least || compare(exact.time(), *least) < 0) {
      least = exact.time();
      first = {here, static_cast<std::uint32_t>(k)};
    }
  }
  first.cost = cost;
  return first;
}

}  // namespace

BodyClosest closest_by_brute_force(std::span<const Body> bodies, const Vec3& point) {
  const PlainArithmetic plain;
  constexpr double kBeyondAll = std::numeric_limits<double>::infinity();
  constexpr soms::detail::Feature kNoGuess = 1;
  BodyClosest nearest;
  nearest.distance = {kBeyondAll, kBeyondAll};
  std::optional<soms::detail::SquaredDistance> least;
  Cost cost;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Closest here = closest_by_brute_force(bodies[k], point);
    cost += here.cost;
    if (!here.triangle) {
      continue;
    }
    const soms::detail::ExactPoint exact(point, triangle_of(bodies[k], *here.triangle), kNoGuess);
    if (!least || compare(exact.squared(), *least) < 0) {
      least = exact.squared();
      nearest = {here, static_cast<std::uint32_t>(k)};
    }
  }
  nearest.cost = cost;
  return nearest;
}

BodyHit closest_hit_by_brute_force(std::span<const Body> bodies, const Ray& ray) {
  return first_hit(bodies, ray, {ray.origin, ray.direction, ray.length, false});
}

BodyHit closest_hit_by_brute_force(std::span<const Body> bodies, const Segment& segment) {
  return first_hit(bodies, segment, {segment.from, segment.to, 1, true});
}

}  // namespace soms::reference
