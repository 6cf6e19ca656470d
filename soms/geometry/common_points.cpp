#include "soms/geometry/common_points.h"

#include "soms/base/arithmetic.h"
#include "soms/base/box.h"
#include "soms/geometry/detail/exact/orientation_exact.h"
#include "soms/geometry/orientation.h"
#include "soms/geometry/triangle_overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace soms {

namespace {

using detail::ScaledNumber;
using Corners = std::array<Vec3, 3>;
using Signs = std::array<Sign, 3>;

Corners corners_of(const Triangle& t) {
  return {t.a, t.b, t.c};
}

Signs signs_of(const Triangle& plane, const Triangle& t) {
  return {orientation(plane.a, plane.b, plane.c, t.a), orientation(plane.a, plane.b, plane.c, t.b),
          orientation(plane.a, plane.b, plane.c, t.c)};
}

bool has_zero(const Signs& signs) {
  return std::find(signs.begin(), signs.end(), Sign::zero) != signs.end();
}

bool has_area(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::yz) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::zx) != Sign::zero;
}

bool opposite(Sign a, Sign b) {
  return a != b && a != Sign::zero && b != Sign::zero;
}

/// Without hypot, of which each C library has its own.
double length(const Vec3& v) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (most == 0) {
    return 0;
  }
  const Vec3 share = {v.x / most, v.y / most, v.z / most};
  return most * std::sqrt(dot(share, share));
}

/// A number from -2 to 2 that grows with the angle of (x, y) from -pi to pi; without atan2,
/// likewise.
double turn(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  if (sum == 0) {
    return 0;
  }
  const double part = y / sum;
  return x >= 0 ? part : std::copysign(2, y) - part;
}

/// Lengths of a pair of triangles: what it is measured in, and what is too near to tell apart.
struct Measure {
  double scale;  ///< power of two that brings the extent near 1
  double merge;

  Measure(const Triangle& s, const Triangle& t) {
    Box box = bounds(s);
    box.grow(bounds(t));
    const Vec3 e = box.extent();
    const double extent = std::max(std::max(e.x, e.y), e.z);
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      most = std::max(most, std::max(std::abs(box.lower[k]), std::abs(box.upper[k])));
    }
    scale = extent > 0 ? std::exp2(std::clamp(-std::ilogb(extent), -1000, 1000)) : 1;
    merge = 1e-13 * extent + 4 * std::numeric_limits<double>::epsilon() * most;
  }
};

/// Point between `p` and `q` where a linear quantity vanishes that is `at_p` and `at_q` there, of
/// opposite signs or one of them 0.
Vec3 zero_between(const Vec3& p, const ScaledNumber& at_p, const Vec3& q,
                  const ScaledNumber& at_q) {
  if (at_p.fraction == 0 || at_q.fraction == 0) {
    return at_p.fraction == 0 ? p : q;
  }
  // What is far below the other may vanish beside it; the sum is above 0.
  const int top = std::max(at_p.exponent, at_q.exponent);
  const double over = std::ldexp(std::abs(at_p.fraction), at_p.exponent - top);
  const double under = std::ldexp(std::abs(at_q.fraction), at_q.exponent - top);
  const double u = over / (over + under);
  return u <= 0.5 ? p + u * (q - p) : q + (1 - u) * (p - q);
}

/// How far a point is above the plane of a triangle, in a unit of the triangle's.
ScaledNumber height(const Vec3& p, const Triangle& t) {
  return detail::determinant(t.a, t.b, t.c, p);
}

/// The two points where edges of `s` go through the plane of `t`.
/// \pre No sign is zero, and not all are equal.
std::pair<Vec3, Vec3> piece(const Triangle& s, const Signs& signs, const Triangle& t) {
  const Corners c = corners_of(s);
  const std::size_t tip = signs[1] == signs[2] ? 0 : signs[0] == signs[2] ? 1 : 2;
  const Vec3& left = c[(tip + 1) % 3];
  const Vec3& right = c[(tip + 2) % 3];
  const ScaledNumber at_tip = height(c[tip], t);
  return {zero_between(c[tip], at_tip, left, height(left, t)),
          zero_between(c[tip], at_tip, right, height(right, t))};
}

CommonPoints segment(const Vec3& a, const Vec3& b, const Measure& measure) {
  CommonPoints result;
  if (length(b - a) <= measure.merge) {
    result.corners[0] = a;
    result.count = 1;
  } else {
    result.corners[0] = a;
    result.corners[1] = b;
    result.count = 2;
  }
  return result;
}

/// General position: both triangles cut the common line of their planes in a piece each.
CommonPoints common_piece(std::pair<Vec3, Vec3> p, std::pair<Vec3, Vec3> q,
                          const Measure& measure) {
  const Vec3 along_p = p.second - p.first;
  const Vec3 along_q = q.second - q.first;
  const Vec3 along = (length(along_p) >= length(along_q) ? along_p : along_q) * measure.scale;
  const Vec3 origin = p.first;
  const auto place = [&](const Vec3& v) { return dot((v - origin) * measure.scale, along); };
  const auto sorted = [&](std::pair<Vec3, Vec3>& ends) {
    if (place(ends.first) > place(ends.second)) {
      std::swap(ends.first, ends.second);
    }
  };
  sorted(p);
  sorted(q);
  const Vec3 begin = place(p.first) >= place(q.first) ? p.first : q.first;
  const Vec3 end = place(p.second) <= place(q.second) ? p.second : q.second;
  if (place(begin) > place(end)) {  // they touch in a point, but for rounding
    return segment(begin, begin, measure);
  }
  return segment(begin, end, measure);
}

bool touch(const Vec3& p, const Triangle& t) {
  return triangles_overlap({p, p, p}, t);
}

/// The point in which two segments cross that touch; nothing if they are parallel: then ends of
/// theirs are what they have in common.
std::optional<Vec3> cross_point(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  // Heights of p and q over the line a b: in every coordinate plane that shows any, they have the
  // same quotient.
  for (const Projection plane : {Projection::xy, Projection::yz, Projection::zx}) {
    const ScaledNumber at_p = detail::determinant2d(a, b, p, plane);
    const ScaledNumber at_q = detail::determinant2d(a, b, q, plane);
    if (at_p.fraction != 0 || at_q.fraction != 0) {
      return zero_between(p, at_p, q, at_q);
    }
  }
  return std::nullopt;
}

/// Points that are corners of the common set: corners of one in the other, edges of one through the
/// other, edges that cross. Which there are is decided exactly.
std::vector<Vec3> common_corners(const Triangle& s, const Signs& s_signs, const Triangle& t,
                                 const Signs& t_signs) {
  std::vector<Vec3> found;
  const auto inside = [&found](const Triangle& of, const Triangle& other) {
    for (const Vec3& p : corners_of(of)) {
      if (touch(p, other)) {
        found.push_back(p);
      }
    }
  };
  const auto through = [&](const Triangle& of, const Signs& signs, const Triangle& other) {
    const Corners c = corners_of(of);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = (i + 1) % 3;
      if (opposite(signs[i], signs[k]) && triangles_overlap({c[i], c[k], c[k]}, other)) {
        found.push_back(zero_between(c[i], height(c[i], other), c[k], height(c[k], other)));
      }
    }
  };
  inside(s, t);
  inside(t, s);
  through(s, s_signs, t);
  through(t, t_signs, s);
  const Corners c = corners_of(s);
  const Corners d = corners_of(t);
  for (std::size_t i = 0; i < 9; ++i) {
    const Vec3& p = c[i / 3];
    const Vec3& q = c[(i / 3 + 1) % 3];
    const Vec3& a = d[i % 3];
    const Vec3& b = d[(i % 3 + 1) % 3];
    if (p != q && a != b && triangles_overlap({p, q, q}, {a, b, b})) {
      if (const auto point = cross_point(p, q, a, b)) {
        found.push_back(*point);
      }
    }
  }
  return found;
}

/// The points without those that are too near to another.
std::vector<Vec3> distinct(const std::vector<Vec3>& points, const Measure& measure) {
  std::vector<Vec3> kept;
  for (const Vec3& p : points) {
    const bool known = std::any_of(kept.begin(), kept.end(),
                                   [&](const Vec3& k) { return length(p - k) <= measure.merge; });
    if (!known) {
      kept.push_back(p);
    }
  }
  return kept;
}

CommonPoints farthest(const std::vector<Vec3>& points, const Measure& measure) {
  std::pair<Vec3, Vec3> ends{points[0], points[0]};
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      const double d = length(points[k] - points[i]);
      if (d > most) {
        most = d;
        ends = {points[i], points[k]};
      }
    }
  }
  return segment(ends.first, ends.second, measure);
}

/// Corners of a convex outline in the plane of `t`, in order around it.
CommonPoints outline(std::vector<Vec3> points, const Triangle& t, const Measure& measure) {
  const Vec3 u = (t.b - t.a) * measure.scale;
  const Vec3 n = cross(u, (t.c - t.a) * measure.scale);
  if (length(n) == 0) {
    return farthest(points, measure);
  }
  Vec3 middle;
  for (const Vec3& p : points) {
    middle += p * (1 / static_cast<double>(points.size()));
  }
  // In a sliver so thin that the quotient is infinite, no four points are distinct.
  const Vec3 v = cross(n, u) * (1 / length(n));
  const auto angle = [&](const Vec3& p) {
    const Vec3 w = (p - middle) * measure.scale;
    return turn(dot(w, u), dot(w, v));
  };
  std::sort(points.begin(), points.end(),
            [&](const Vec3& p, const Vec3& q) { return angle(p) < angle(q); });
  CommonPoints result;
  result.count = std::min(points.size(), result.corners.size());
  std::copy_n(points.begin(), result.count, result.corners.begin());
  return result;
}

}  // namespace

CommonPoints common_points(const Triangle& s, const Triangle& t) {
  const PlainArithmetic plain;
  if (!triangles_overlap(s, t)) {
    return {};
  }
  const Measure measure(s, t);
  const Signs s_signs = signs_of(t, s);
  const Signs t_signs = signs_of(s, t);
  if (!has_zero(s_signs) && !has_zero(t_signs)) {
    return common_piece(piece(s, s_signs, t), piece(t, t_signs, s), measure);
  }
  const std::vector<Vec3> points = distinct(common_corners(s, s_signs, t, t_signs), measure);
  const bool in_one_plane = s_signs == Signs{} && t_signs == Signs{};
  if (points.size() > 2 && in_one_plane && has_area(s) && has_area(t)) {
    return outline(points, s, measure);
  }
  return farthest(points, measure);
}

}  // namespace soms
