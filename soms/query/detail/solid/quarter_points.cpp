#include "soms/query/detail/solid/quarter_points.h"

#include "soms/base/double_limits.h"
#include "soms/base/pose.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// The points lie this part of the segment's length beside it.
constexpr double kBeside = 1.0 / 32;

Vec3 unit_normal(const Triangle& t) {
  const Vec3 n = cross(t.b - t.a, t.c - t.a);
  return (1 / std::sqrt(dot(n, n))) * n;
}

/// Where a triangle meets a plane: two points, as places along a direction.
struct Stretch {
  double from = kInfinity;
  double to = -kInfinity;
  Vec3 first;
  Vec3 last;

  void add(const Vec3& p, const Vec3& along) {
    const double place = dot(p, along);
    if (place < from) {
      from = place;
      first = p;
    }
    if (place > to) {
      to = place;
      last = p;
    }
  }
};

/// Of the edges of `t` that reach through the plane of `origin` and `normal`.
Stretch stretch_of(const Triangle& t, const Vec3& origin, const Vec3& normal, const Vec3& along) {
  const std::array<Vec3, 3> p{t.a, t.b, t.c};
  Stretch stretch;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& q = p[(i + 1) % 3];
    const double here = dot(p[i] - origin, normal);
    const double there = dot(q - origin, normal);
    if ((here < 0) != (there < 0)) {
      stretch.add(p[i] + (here / (here - there)) * (q - p[i]), along);
    }
  }
  return stretch;
}

bool in_range(const Vec3& p) {
  return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
         std::abs(p.z) <= kMaxCoordinate;
}

}  // namespace

std::optional<std::array<Vec3, 4>> quarter_points(const Triangle& s, const Triangle& t) {
  const Vec3 m = unit_normal(s);
  const Vec3 n = unit_normal(t);
  const Vec3 along = cross(m, n);
  const Stretch of_s = stretch_of(s, t.a, n, along);
  const Stretch of_t = stretch_of(t, s.a, m, along);
  const Vec3 first = of_s.from > of_t.from ? of_s.first : of_t.first;
  const Vec3 last = of_s.to < of_t.to ? of_s.last : of_t.last;
  const Vec3 segment = last - first;
  if (!(dot(segment, along) > 0)) {
    return std::nullopt;
  }
  const Vec3 middle = first + 0.5 * segment;
  const double beside = kBeside * std::sqrt(dot(segment, segment));
  const Vec3 sum = m + n;
  const Vec3 difference = m - n;
  const Vec3 u = (beside / std::sqrt(dot(sum, sum))) * sum;
  const Vec3 v = (beside / std::sqrt(dot(difference, difference))) * difference;
  const std::array<Vec3, 4> points{middle + u, middle - u, middle + v, middle - v};
  if (!std::all_of(points.begin(), points.end(), in_range)) {
    return std::nullopt;
  }
  return points;
}

}  // namespace soms::detail
