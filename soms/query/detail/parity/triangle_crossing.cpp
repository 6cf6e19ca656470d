#include "soms/query/detail/parity/triangle_crossing.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace soms::detail {

namespace {

/// The plane across an axis.
Projection across(std::size_t axis) {
  return axis == 0 ? Projection::yz : axis == 1 ? Projection::zx : Projection::xy;
}

/// Signs of the areas between a point and a triangle's three edges, in a coordinate plane.
struct EdgeSigns {
  EdgeSigns(const Triangle& t, const Vec3& p, Projection plane, Predicates& predicates)
      : sign{predicates.orientation2d(t.a, t.b, p, plane),
             predicates.orientation2d(t.b, t.c, p, plane),
             predicates.orientation2d(t.c, t.a, p, plane)} {}

  [[nodiscard]] bool any(Sign s) const { return sign[0] == s || sign[1] == s || sign[2] == s; }

  /// The point is strictly outside of the projected triangle, which may be a segment.
  [[nodiscard]] bool mixed() const { return any(Sign::negative) && any(Sign::positive); }

  std::array<Sign, 3> sign;
};

bool in_box(const Triangle& t, const Vec3& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < std::min({t.a[k], t.b[k], t.c[k]}) || p[k] > std::max({t.a[k], t.b[k], t.c[k]})) {
      return false;
    }
  }
  return true;
}

/// Whether a point is in the closed triangle. Seen along each axis a triangle in a plane is one or
/// a segment; one without area is a segment in all, on whose line the point is if no signs are
/// mixed, and whose box then tells.
bool contains_point(const Triangle& t, const Vec3& p, Predicates& predicates) {
  if (!in_box(t, p) || predicates.orientation(t.a, t.b, t.c, p) != Sign::zero) {
    return false;
  }
  for (const Projection plane : {Projection::xy, Projection::yz, Projection::zx}) {
    if (EdgeSigns(t, p, plane, predicates).mixed()) {
      return false;
    }
  }
  return true;
}

Sign sign_of(double from, double to) {
  return from < to ? Sign::positive : from > to ? Sign::negative : Sign::zero;
}

/// The sign for the point moved by e and e^2.
Sign beside(Sign sign, const Vec3& from, const Vec3& to, Projection plane) {
  if (sign == Sign::zero) {
    sign = sign_of(second_coordinate(to, plane), second_coordinate(from, plane));
  }
  return sign == Sign::zero ? sign_of(first_coordinate(from, plane), first_coordinate(to, plane))
                            : sign;
}

}  // namespace

RayHit triangle_crossing(const Triangle& t, const Vec3& p, std::size_t axis, bool forward,
                         bool& exact) {
  Predicates predicates;
  const Projection plane = across(axis);
  const EdgeSigns signs(t, p, plane, predicates);
  RayHit hit = RayHit::miss;
  if (!signs.any(Sign::negative) && !signs.any(Sign::positive)) {
    // Parallel to the ray, or without area.
    hit = contains_point(t, p, predicates) ? RayHit::on : RayHit::miss;
  } else if (!signs.mixed()) {
    const Sign side = predicates.orientation(t.a, t.b, t.c, p);
    const Sign first = beside(signs.sign[0], t.a, t.b, plane);
    const Sign second = beside(signs.sign[1], t.b, t.c, plane);
    const Sign third = beside(signs.sign[2], t.c, t.a, plane);
    if (side == Sign::zero) {
      hit = RayHit::on;
    } else if (first == second && second == third && (side == first) != forward) {
      hit = RayHit::cross;
    }
  }
  exact = exact || predicates.exact;
  return hit;
}

Sign side_of_ray(const Vec3& from, const Vec3& to, const Vec3& p, std::size_t axis,
                 Predicates& predicates) {
  const Projection plane = across(axis);
  return beside(predicates.orientation2d(from, to, p, plane), from, to, plane);
}

bool crosses_to_front(const Triangle& t, std::size_t axis, bool forward) {
  Predicates predicates;
  return (predicates.orientation2d(t.a, t.b, t.c, across(axis)) == Sign::positive) == forward;
}

}  // namespace soms::detail
