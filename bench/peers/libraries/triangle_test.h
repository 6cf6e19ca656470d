/// \file
/// A fast triangle test for libraries that bring none that touches count in: signs in plain double
/// with an error bound, and the exact test of the loan where a sign is not sure.
#pragma once

#include "bench/peers/libraries/library.h"

#include <array>
#include <cmath>
#include <utility>

namespace soms::bench {

/// The moved vertex, the same bits as Pose::apply, which these files cannot call: they must be
/// compiled without contraction.
inline Vec3 moved(const Pose& pose, const Vec3& v) {
  const auto& m = pose.m;
  return {((m[0] * v.x + m[1] * v.y) + m[2] * v.z) + m[3],
          ((m[4] * v.x + m[5] * v.y) + m[6] * v.z) + m[7],
          ((m[8] * v.x + m[9] * v.y) + m[10] * v.z) + m[11]};
}

inline Triangle moved(const Pose& pose, const Triangle& t) {
  return {moved(pose, t.a), moved(pose, t.b), moved(pose, t.c)};
}

namespace detail {

inline double l1_norm(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// Side of a plane through `origin`: 1 or -1, or 0 where rounding might have decided. The bound is
/// Shewchuk's for a 3 x 3 determinant (7.8e-16 of its permanent), with the product of sums, which
/// is never less, for the permanent.
struct Plane {
  Vec3 origin;
  Vec3 normal;
  double error;

  Plane(const Vec3& a, const Vec3& b, const Vec3& c)
      : origin(a), normal(cross(b - a, c - a)), error(1e-15 * l1_norm(b - a) * l1_norm(c - a)) {}

  [[nodiscard]] int side(const Vec3& p) const {
    const Vec3 w = p - origin;
    const double height = dot(w, normal);
    return std::abs(height) > error * l1_norm(w) + 1e-290 ? (height > 0 ? 1 : -1) : 0;
  }
};

using Corners = std::array<Vec3, 3>;
using Sides = std::array<int, 3>;

inline Sides sides(const Plane& plane, const Corners& t) {
  return {plane.side(t[0]), plane.side(t[1]), plane.side(t[2])};
}

inline bool all_beyond(const Sides& s) {
  return s[0] != 0 && s[0] == s[1] && s[1] == s[2];
}

inline bool sure(const Sides& s) {
  return s[0] != 0 && s[1] != 0 && s[2] != 0;
}

/// Turns `t` so that the corner alone on its side comes first, and `other` over if that side is
/// the negative one; true if so.
inline bool single_corner_first(Corners& t, const Sides& s, Corners& other) {
  const std::size_t single = s[1] == s[2] ? 0 : s[0] == s[2] ? 1 : 2;
  t = {t[single], t[(single + 1) % 3], t[(single + 2) % 3]};
  if (s[single] < 0) {
    std::swap(other[1], other[2]);
  }
  return s[single] < 0;
}

}  // namespace detail

/// Do two closed triangles share a point? Exact.
/// \source Guigue and Devillers 2003, in general position.
inline bool triangles_touch(const Triangle& s, const Triangle& t, const Loan& loan) {
  using namespace detail;
  Corners p{s.a, s.b, s.c};
  Corners q{t.a, t.b, t.c};
  const Sides of_p = sides(Plane(q[0], q[1], q[2]), p);
  if (all_beyond(of_p)) {
    return false;
  }
  const Sides of_q = sides(Plane(p[0], p[1], p[2]), q);
  if (all_beyond(of_q)) {
    return false;
  }
  if (!sure(of_p) || !sure(of_q)) {
    return loan.triangles_overlap(s, t);
  }
  // Both single corners are to see the other triangle counter-clockwise. Turning q over moves its
  // sides along with its corners.
  const bool over = single_corner_first(p, of_p, q);
  single_corner_first(q, over ? Sides{of_q[0], of_q[2], of_q[1]} : of_q, p);
  const int first = Plane(p[0], p[1], q[0]).side(q[1]);
  const int second = Plane(p[0], p[2], q[2]).side(q[0]);
  if (first > 0 || second > 0) {
    return false;
  }
  return (first < 0 && second < 0) || loan.triangles_overlap(s, t);
}

}  // namespace soms::bench
