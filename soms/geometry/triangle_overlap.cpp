#include "soms/geometry/triangle_overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/exact/predicates.h"
#include "soms/geometry/detail/flat_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace soms {

namespace {

using detail::Predicates;

/// Filtered determinants of a triangle's corners against the plane of another, with one bound.
struct Sides {
  std::array<double, 3> det;
  double bound;

  /// True if all corners certainly lie strictly on one side: then the triangles are apart, and the
  /// plane's triangle has area, whatever the other is.
  [[nodiscard]] bool apart() const {
    return std::min(std::min(det[0], det[1]), det[2]) > bound ||
           std::max(std::max(det[0], det[1]), det[2]) < -bound;
  }

  [[nodiscard]] bool certain() const {
    return std::min(std::min(std::abs(det[0]), std::abs(det[1])), std::abs(det[2])) > bound;
  }
};

Sides sides_of(const Triangle& plane_of, const Triangle& t) {
  const detail::Plane plane(plane_of.a, plane_of.b, plane_of.c);
  const Vec3 a = t.a - plane.origin;
  const Vec3 b = t.b - plane.origin;
  const Vec3 c = t.c - plane.origin;
  const Vec3 reach{std::max(std::max(std::abs(a.x), std::abs(b.x)), std::abs(c.x)),
                   std::max(std::max(std::abs(a.y), std::abs(b.y)), std::abs(c.y)),
                   std::max(std::max(std::abs(a.z), std::abs(b.z)), std::abs(c.z))};
  return {{dot(plane.normal, a), dot(plane.normal, b), dot(plane.normal, c)},
          detail::error_bound(plane, reach)};
}

using Signs = std::array<Sign, 3>;

/// Exact signs of `sides`, taking again those that its bound left open.
Signs decide(const Sides& sides, const Triangle& plane, const Triangle& t, Predicates& predicates) {
  const std::array<const Vec3*, 3> corners{&t.a, &t.b, &t.c};
  Signs signs{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double det = sides.det[i];
    signs[i] = det > sides.bound ? Sign::positive
               : det < -sides.bound
                   ? Sign::negative
                   : predicates.orientation(plane.a, plane.b, plane.c, *corners[i]);
  }
  return signs;
}

bool strictly_one_sided(const Signs& s) {
  return s[0] != Sign::zero && s[0] == s[1] && s[0] == s[2];
}

bool all_zero(const Signs& s) {
  return s[0] == Sign::zero && s[1] == Sign::zero && s[2] == Sign::zero;
}

bool share_corner(const Triangle& s, const Triangle& t) {
  const auto is_corner = [&t](const Vec3& p) { return p == t.a || p == t.b || p == t.c; };
  return is_corner(s.a) || is_corner(s.b) || is_corner(s.c);
}

/// A triangle turned so that its first corner is alone on its closed side of the other's plane: the
/// edges from it are those that cross. `above` tells whether that is the positive side.
struct TurnedTriangle {
  Vec3 tip;
  Vec3 left;
  Vec3 right;
  bool above;
};

/// \pre `signs` are neither all zero nor strictly one-sided.
TurnedTriangle turned_triangle(const Triangle& t, const Signs& signs) {
  const auto positive = std::count(signs.begin(), signs.end(), Sign::positive);
  const auto negative = std::count(signs.begin(), signs.end(), Sign::negative);
  // Alone on its side, or else alone in the plane with both others beyond it.
  const Sign tip = positive == 1 ? Sign::positive : negative == 1 ? Sign::negative : Sign::zero;
  const bool above = positive == 1 || (negative == 2 && positive == 0);
  if (signs[0] == tip) {
    return {t.a, t.b, t.c, above};
  }
  if (signs[1] == tip) {
    return {t.b, t.c, t.a, above};
  }
  return {t.c, t.a, t.b, above};
}

/// General position: both triangles meet the line common to their planes, in one interval each. Two
/// signs tell whether the intervals meet (Guigue and Devillers).
bool intervals_meet(const Triangle& s, const Signs& s_signs, const Triangle& t,
                    const Signs& t_signs, Predicates& predicates) {
  TurnedTriangle p = turned_triangle(s, s_signs);
  TurnedTriangle q = turned_triangle(t, t_signs);
  // Each tip is brought to the positive side by turning the other triangle over.
  if (!p.above) {
    std::swap(q.left, q.right);
  }
  if (!q.above) {
    std::swap(p.left, p.right);
  }
  return predicates.orientation(p.tip, p.left, q.tip, q.left) != Sign::positive &&
         predicates.orientation(p.tip, p.right, q.right, q.tip) != Sign::positive;
}

/// What is left when neither plane's filter distinguished the triangles.
bool decide_overlap(const Triangle& s, const Sides& s_sides, const Triangle& t,
                    const Sides& t_sides, Predicates& predicates) {
  if (!(s_sides.certain() && t_sides.certain()) && share_corner(s, t)) {
    return true;
  }
  const Signs s_signs = decide(s_sides, t, s, predicates);
  if (strictly_one_sided(s_signs)) {
    return false;
  }
  const Signs t_signs = decide(t_sides, s, t, predicates);
  if (strictly_one_sided(t_signs)) {
    return false;
  }
  if (all_zero(s_signs) || all_zero(t_signs)) {
    return detail::flat_overlap(s, t, predicates);
  }
  return intervals_meet(s, s_signs, t, t_signs, predicates);
}

}  // namespace

bool triangles_overlap(const Triangle& s, const Triangle& t, std::uint64_t* exact_tests) {
  const PlainArithmetic plain;
  const Sides s_sides = sides_of(t, s);
  if (s_sides.apart()) {
    return false;
  }
  const Sides t_sides = sides_of(s, t);
  if (t_sides.apart()) {
    return false;
  }
  Predicates predicates;
  const bool answer = decide_overlap(s, s_sides, t, t_sides, predicates);
  if (predicates.exact && exact_tests != nullptr) {
    ++*exact_tests;
  }
  return answer;
}

}  // namespace soms
