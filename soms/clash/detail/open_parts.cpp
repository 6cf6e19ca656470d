#include "soms/clash/detail/open_parts.h"

#include "soms/base/box.h"
#include "soms/geometry/orientation.h"

#include <algorithm>
#include <array>

namespace soms::detail {

namespace {

bool has_area(const Triangle& t) {
  return orientation2d(t.a, t.b, t.c, Projection::xy) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::yz) != Sign::zero ||
         orientation2d(t.a, t.b, t.c, Projection::zx) != Sign::zero;
}

bool are_opposite(Sign s, Sign t) {
  return s != Sign::zero && t != Sign::zero && s != t;
}

/// True if the line through `p` and `q` goes through the triangle strictly inside it.
bool line_goes_inside(const Vec3& p, const Vec3& q, const Triangle& t) {
  const Sign side = orientation(p, q, t.a, t.b);
  return side != Sign::zero && orientation(p, q, t.b, t.c) == side &&
         orientation(p, q, t.c, t.a) == side;
}

/// An edge of `s` goes through `t`.
bool has_edge_through(const Triangle& s, const Triangle& t) {
  const std::array<Vec3, 3> corners{s.a, s.b, s.c};
  std::array<Sign, 3> side{};
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = orientation(t.a, t.b, t.c, corners[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (are_opposite(side[k], side[next]) && line_goes_inside(corners[k], corners[next], t) &&
        has_area(s)) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool pass_through(const Triangle& s, const Triangle& t) {
  return has_edge_through(s, t) || has_edge_through(t, s);
}

bool may_be_inside(const PartBody& inner, const PartBody& outer) {
  const Box box = outer.box();
  return std::any_of(inner.components.begin(), inner.components.end(),
                     [&](const PartComponent& component) { return box.contains(component.box); });
}

}  // namespace soms::detail
