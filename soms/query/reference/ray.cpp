#include "soms/query/reference/ray.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/detail/ray/ray_line.h"
#include "soms/query/reference/detail/moved_triangles.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace soms::reference {

namespace {

using soms::detail::ExactRay;
using soms::detail::Feature;
using soms::detail::line_of;
using soms::detail::RayLine;

/// A triangle that a ray meets.
struct TwinHit {
  TriangleId id;
  Triangle triangle;
  ExactRay exact;
  std::size_t crossing;  // the place in the list of another one, or its own
};

/// All, by time, then by number.
std::vector<TwinHit> meetings(const Body& body, const RayLine& line, std::optional<TriangleId> skip,
                              Cost& cost) {
  const std::vector<Triangle> triangles = detail::moved_triangles(body.shape.mesh(), body.pose);
  std::vector<TwinHit> met;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    if (id == skip) {
      continue;
    }
    ++cost.exact_tests;
    ExactRay exact(line, triangles[i]);
    if (exact.hit()) {
      met.push_back({id, triangles[i], std::move(exact), 0});
    }
  }
  std::stable_sort(met.begin(), met.end(), [](const TwinHit& a, const TwinHit& b) {
    return compare(a.exact.time(), b.exact.time()) < 0;
  });
  return met;
}

/// Two triangles have the corner or edge in common that holds the point where the ray meets them.
bool connected(const TwinHit& a, const TwinHit& b) {
  for (const Feature f : a.exact.features()) {
    for (const Feature g : b.exact.features()) {
      if (f != 0 && g != 0 && soms::detail::same_corners(a.triangle, f, b.triangle, g)) {
        return true;
      }
    }
  }
  return false;
}

/// Each takes the number of the first one of its crossing.
void connect(std::vector<TwinHit>& met) {
  for (std::size_t i = 0; i < met.size(); ++i) {
    met[i].crossing = i;
    for (std::size_t j = i; j-- > 0 && compare(met[j].exact.time(), met[i].exact.time()) == 0;) {
      if (met[i].crossing == met[j].crossing || !connected(met[i], met[j])) {
        continue;
      }
      const std::size_t old = std::max(met[i].crossing, met[j].crossing);
      const std::size_t first = std::min(met[i].crossing, met[j].crossing);
      for (std::size_t k = 0; k <= i; ++k) {
        met[k].crossing = met[k].crossing == old ? first : met[k].crossing;
      }
    }
  }
}

CrossingKind kind_of(const std::vector<TwinHit>& met, std::size_t crossing) {
  int fronts = 0;
  int backs = 0;
  for (const TwinHit& m : met) {
    if (m.crossing == crossing && m.exact.crossed_beside()) {
      (m.exact.side() > 0 ? fronts : backs) += 1;
    }
  }
  return (fronts + backs) % 2 == 0 ? CrossingKind::graze
         : fronts > backs          ? CrossingKind::enter
                                   : CrossingKind::leave;
}

ClosestHit closest(const Body& body, const RayLine& line, std::optional<TriangleId> skip) {
  const PlainArithmetic plain;
  ClosestHit answer;
  const std::vector<TwinHit> met = meetings(body, line, skip, answer.cost);
  if (!met.empty()) {
    const ExactRay& first = met.front().exact;
    answer.t = bracket(first.time());
    answer.triangle = met.front().id;
    answer.point = first.point();
    answer.front = first.side() > 0;
  }
  return answer;
}

AllHits all(const Body& body, const RayLine& line, std::optional<TriangleId> skip) {
  const PlainArithmetic plain;
  AllHits answer;
  std::vector<TwinHit> met = meetings(body, line, skip, answer.cost);
  connect(met);
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (met[i].crossing != i) {
      continue;
    }
    const Bracket t = bracket(met[i].exact.time());
    answer.lower.push_back(t.lower);
    answer.upper.push_back(t.upper);
    answer.kind.push_back(kind_of(met, i));
    for (const TwinHit& m : met) {
      if (m.crossing == i) {
        answer.triangle.push_back(m.id);
      }
    }
    answer.triangle_offsets.push_back(answer.triangle.size());
  }
  answer.offsets.push_back(answer.lower.size());
  answer.coverage.push_back(Coverage::complete);
  answer.costs.push_back(answer.cost);
  return answer;
}

}  // namespace

ClosestHit closest_hit_by_brute_force(const Body& body, const Ray& ray,
                                      std::optional<TriangleId> skip) {
  return closest(body, line_of(ray), skip);
}

AllHits all_hits_by_brute_force(const Body& body, const Ray& ray, std::optional<TriangleId> skip) {
  return all(body, line_of(ray), skip);
}

}  // namespace soms::reference
