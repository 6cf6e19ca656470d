#include "tests/properties/near_touch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::test {

namespace {

using Real = long double;

struct Point {
  Real x;
  Real y;
  Real z;
};

Point point(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Point operator-(const Point& p, const Point& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

Point along(const Point& p, Real s, const Point& d) {
  return {p.x + s * d.x, p.y + s * d.y, p.z + s * d.z};
}

Real dot(const Point& p, const Point& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

Real length(const Point& p) {
  return std::sqrt(dot(p, p));
}

Real clamp01(Real s) {
  return std::min<Real>(1, std::max<Real>(0, s));
}

/// Distance of a point and its foot on a segment.
Real point_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const Real s = dot(d, d) > 0 ? clamp01(dot(p - a, d) / dot(d, d)) : 0;
  return length(p - along(a, s, d));
}

/// Distance of a point and its foot in a triangle; infinite where the foot is outside.
Real point_face(const Point& p, const std::array<Point, 3>& t) {
  const Point u = t[1] - t[0];
  const Point v = t[2] - t[0];
  const Point w = p - t[0];
  const Real uu = dot(u, u);
  const Real uv = dot(u, v);
  const Real vv = dot(v, v);
  const Real det = uu * vv - uv * uv;
  const Real r = (vv * dot(u, w) - uv * dot(v, w)) / det;
  const Real s = (uu * dot(v, w) - uv * dot(u, w)) / det;
  if (!(det > 0 && r >= 0 && s >= 0 && r + s <= 1)) {
    return std::numeric_limits<Real>::infinity();
  }
  return length(p - along(along(t[0], r, u), s, v));
}

/// Distance of the feet of the common perpendicular of two segments; infinite where they are
/// outside or the segments are parallel.
Real segment_segment(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a;
  const Point v = d - c;
  const Point w = a - c;
  const Real det = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  const Real s = (dot(u, v) * dot(v, w) - dot(v, v) * dot(u, w)) / det;
  const Real r = (dot(u, u) * dot(v, w) - dot(u, v) * dot(u, w)) / det;
  if (!(det > 0 && s >= 0 && s <= 1 && r >= 0 && r <= 1)) {
    return std::numeric_limits<Real>::infinity();
  }
  return length(along(a, s, u) - along(c, r, v));
}

Vec3 corner(Rng& rng) {
  return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
}

}  // namespace

std::pair<Triangle, Triangle> nearly_touching(Rng& rng) {
  const Triangle s{corner(rng), corner(rng), corner(rng)};
  Triangle t{corner(rng), corner(rng), corner(rng)};
  const double along_edge = rng.unit();
  const double into_face = (1 - along_edge) * rng.unit();
  const Vec3 on_edge = s.a + along_edge * (s.b - s.a);
  const Vec3 on_face = on_edge + into_face * (s.c - s.a);
  switch (rng.below(4)) {
    case 0:
      t.a = on_face;
      break;
    case 1:
      t.a = on_edge;
      break;
    case 2:
      t.a = s.a + (on_face - on_edge);
      t.b = s.b;
      break;
    default:
      // The middle of the edge ab of t meets the edge ab of s.
      t.a = on_edge + 0.5 * (t.a - t.b);
      t.b = on_edge + (on_edge - t.a);
      break;
  }
  return {s, t};
}

double distance_bound(const Triangle& s, const Triangle& t) {
  const std::array<Point, 3> p{point(s.a), point(s.b), point(s.c)};
  const std::array<Point, 3> q{point(t.a), point(t.b), point(t.c)};
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, point_face(p[i], q), point_face(q[i], p)});
    for (std::size_t j = 0; j < 3; ++j) {
      least = std::min({least, point_segment(p[i], q[j], q[(j + 1) % 3]),
                        point_segment(q[i], p[j], p[(j + 1) % 3]),
                        segment_segment(p[i], p[(i + 1) % 3], q[j], q[(j + 1) % 3])});
    }
  }
  return static_cast<double>(least);
}

double rounding_bound(const Pose& pose, const Triangle& t) {
  double most = 0;
  for (const Vec3& v : {t.a, t.b, t.c}) {
    double squared = 0;
    for (std::size_t row = 0; row < 3; ++row) {
      const double size = std::abs(pose.m[4 * row] * v.x) + std::abs(pose.m[4 * row + 1] * v.y) +
                          std::abs(pose.m[4 * row + 2] * v.z) + std::abs(pose.m[4 * row + 3]);
      // Four roundings at most on any term: two products and sums, the last sum, the shift.
      const double error = 4.01 * 0x1p-53 * size;
      squared += error * error;
    }
    most = std::max(most, std::sqrt(squared));
  }
  return most;
}

}  // namespace soms::test
