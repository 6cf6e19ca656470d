#include "soms/scene/reference/body_queries.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/exact_point.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/detail/ray/ray_line.h"
#include "soms/query/reference/closest.h"
#include "soms/query/reference/ray.h"
#include "soms/scene/detail/search/body_search.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace soms::reference {

namespace {

using soms::detail::ExactRay;
using soms::detail::moved_triangle;
using soms::detail::RayLine;

BodyHit first_hit(std::span<const Body> bodies, const Ray& line, const RayLine& exact_line) {
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
    const ExactRay exact(exact_line, moved_triangle(bodies[k], *here.triangle));
    if (!least || compare(exact.time(), *least) < 0) {
      least = exact.time();
      first = {here, static_cast<std::uint32_t>(k)};
    }
  }
  first.cost = cost;
  return first;
}

/// A crossing, with its exact time.
struct TimedCrossing {
  soms::detail::RayTime t;
  std::uint32_t body = 0;
  std::size_t place = 0;  ///< in the row of its body
};

/// The crossings of rows, one a body, in their order: each is put before the first that is later.
std::vector<TimedCrossing> in_order(std::span<const Body> bodies, const std::vector<AllHits>& rows,
                                    const RayLine& line) {
  std::vector<TimedCrossing> crossings;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t place = 0; place < rows[k].kind.size(); ++place) {
      const TriangleId triangle = rows[k].triangle[rows[k].triangle_offsets[place]];
      const auto t = ExactRay(line, moved_triangle(bodies[k], triangle)).time();
      const auto later =
          std::find_if(crossings.begin(), crossings.end(),
                       [&](const TimedCrossing& other) { return compare(t, other.t) < 0; });
      crossings.insert(later, {t, static_cast<std::uint32_t>(k), place});
    }
  }
  return crossings;
}

BodyAllHits every_hit(std::span<const Body> bodies, const Ray& line, const RayLine& exact_line) {
  const PlainArithmetic plain;
  std::vector<AllHits> rows;
  BodyAllHits all;
  for (const Body& body : bodies) {
    rows.push_back(all_hits_by_brute_force(body, line));
    all.cost += rows.back().cost;
  }
  for (const TimedCrossing& crossing : in_order(bodies, rows, exact_line)) {
    const AllHits& row = rows[crossing.body];
    all.lower.push_back(row.lower[crossing.place]);
    all.upper.push_back(row.upper[crossing.place]);
    all.kind.push_back(row.kind[crossing.place]);
    all.body.push_back(crossing.body);
    for (std::uint64_t i = row.triangle_offsets[crossing.place];
         i < row.triangle_offsets[crossing.place + 1]; ++i) {
      all.triangle.push_back(row.triangle[i]);
    }
    all.triangle_offsets.push_back(all.triangle.size());
  }
  all.offsets.push_back(all.kind.size());
  all.coverage = {Coverage::complete};
  all.costs = {all.cost};
  return all;
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
    const soms::detail::ExactPoint exact(point, moved_triangle(bodies[k], *here.triangle),
                                         kNoGuess);
    if (!least || compare(exact.squared(), *least) < 0) {
      least = exact.squared();
      nearest = {here, static_cast<std::uint32_t>(k)};
    }
  }
  nearest.cost = cost;
  return nearest;
}

BodyHit closest_hit_by_brute_force(std::span<const Body> bodies, const Ray& ray) {
  return first_hit(bodies, ray, soms::detail::line_of(ray));
}

BodyAllHits all_hits_by_brute_force(std::span<const Body> bodies, const Ray& ray) {
  return every_hit(bodies, ray, soms::detail::line_of(ray));
}

}  // namespace soms::reference
