#include "soms/query/detail/solid/planar_triangles.h"

#include <algorithm>
#include <array>

namespace soms::detail {

namespace {

constexpr std::array<Projection, 3> kProjections{Projection::xy, Projection::yz, Projection::zx};

std::array<Vec3, 3> corners_of(const Triangle& t) {
  return {t.a, t.b, t.c};
}

/// Sides of the plane of `t` on which the corners of `s` lie.
std::array<Sign, 3> sides_of(const Triangle& t, const Triangle& s, Predicates& predicates) {
  return {predicates.orientation(t.a, t.b, t.c, s.a), predicates.orientation(t.a, t.b, t.c, s.b),
          predicates.orientation(t.a, t.b, t.c, s.c)};
}

auto count_of(const std::array<Sign, 3>& signs, Sign sign) {
  return std::count(signs.begin(), signs.end(), sign);
}

/// An edge of one has the other on its outer side, in a plane in which both have area.
bool parted(const Triangle& t, const Triangle& s, Projection plane, Predicates& predicates) {
  const auto p = corners_of(t);
  const auto q = corners_of(s);
  const Sign inner = predicates.orientation2d(t.a, t.b, t.c, plane);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::none_of(q.begin(), q.end(), [&](const Vec3& corner) {
          return predicates.orientation2d(p[i], p[(i + 1) % 3], corner, plane) == inner;
        })) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool has_area(const Triangle& t, Predicates& predicates) {
  return std::any_of(kProjections.begin(), kProjections.end(), [&](Projection plane) {
    return predicates.orientation2d(t.a, t.b, t.c, plane) != Sign::zero;
  });
}

bool may_cut(const Triangle& t, const Triangle& s, Predicates& predicates) {
  const auto sides = sides_of(t, s, predicates);
  const auto zeros = count_of(sides, Sign::zero);
  const bool mixed = count_of(sides, Sign::positive) > 0 && count_of(sides, Sign::negative) > 0;
  if (!mixed && zeros < 2) {
    return false;
  }
  if (zeros == 2) {
    // An edge lies in the plane: it cuts nothing if it is an edge of t.
    const auto p = corners_of(t);
    const auto q = corners_of(s);
    const auto shared = [&](std::size_t i) {
      return sides[i] != Sign::zero || std::find(p.begin(), p.end(), q[i]) != p.end();
    };
    return !(shared(0) && shared(1) && shared(2));
  }
  if (zeros == 3) {
    return true;
  }
  const auto back = sides_of(s, t, predicates);
  return count_of(back, Sign::positive) != 3 && count_of(back, Sign::negative) != 3;
}

bool may_share_area(const Triangle& t, const Triangle& s, Predicates& predicates) {
  if (count_of(sides_of(t, s, predicates), Sign::zero) != 3) {
    return false;
  }
  for (const Projection plane : kProjections) {
    if (predicates.orientation2d(t.a, t.b, t.c, plane) != Sign::zero) {
      return predicates.orientation2d(s.a, s.b, s.c, plane) != Sign::zero &&
             !parted(t, s, plane, predicates) && !parted(s, t, plane, predicates);
    }
  }
  return true;
}

}  // namespace soms::detail
