#include "soms/query/detail/solid/planar_triangles.h"

#include <algorithm>
#include <array>

namespace soms::detail {

namespace {

constexpr std::array<Projection, 3> kProjections{Projection::xy, Projection::yz, Projection::zx};

std::array<Vec3, 3> corners_of(const Triangle& t) {
  return {t.a, t.b, t.c};
}

/// True for a corner of `t`, of which no arithmetic is needed to see that it lies in the plane of
/// t.
bool is_corner(const Vec3& p, const Triangle& t) {
  return p == t.a || p == t.b || p == t.c;
}

/// The side of the plane of `t` on which a point lies.
Sign side_of(const Triangle& t, const Vec3& p, Predicates& predicates) {
  return is_corner(p, t) ? Sign::zero : predicates.orientation(t.a, t.b, t.c, p);
}

/// Sides of the plane of `t` on which the corners of `s` lie.
std::array<Sign, 3> sides_of(const Triangle& t, const Triangle& s, Predicates& predicates) {
  return {side_of(t, s.a, predicates), side_of(t, s.b, predicates), side_of(t, s.c, predicates)};
}

auto count_of(const std::array<Sign, 3>& signs, Sign sign) {
  return std::count(signs.begin(), signs.end(), sign);
}

/// The corners of `s` lie in the plane of `t`.
bool is_coplanar(const Triangle& t, const Triangle& s, Predicates& predicates) {
  const auto corners = corners_of(s);
  return std::all_of(corners.begin(), corners.end(),
                     [&](const Vec3& p) { return side_of(t, p, predicates) == Sign::zero; });
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

/// False only if triangles of one plane have no area in common. \pre `t` has area.
bool share_area(const Triangle& t, const Triangle& s, Predicates& predicates) {
  const auto* const plane =
      std::find_if(kProjections.begin(), kProjections.end(), [&](Projection projection) {
        return predicates.orientation2d(t.a, t.b, t.c, projection) != Sign::zero;
      });
  return plane == kProjections.end() ||
         (predicates.orientation2d(s.a, s.b, s.c, *plane) != Sign::zero &&
          !parted(t, s, *plane, predicates) && !parted(s, t, *plane, predicates));
}

}  // namespace

bool has_area(const Triangle& t, Predicates& predicates) {
  return std::any_of(kProjections.begin(), kProjections.end(), [&](Projection plane) {
    return predicates.orientation2d(t.a, t.b, t.c, plane) != Sign::zero;
  });
}

TriangleCut cut_of(const Triangle& t, const Triangle& s, Predicates& predicates) {
  const auto sides = sides_of(t, s, predicates);
  const auto zeros = count_of(sides, Sign::zero);
  const bool mixed = count_of(sides, Sign::positive) > 0 && count_of(sides, Sign::negative) > 0;
  if (!mixed && zeros < 2) {
    return {};
  }
  if (zeros == 3) {
    return {share_area(t, s, predicates) ? CutKind::coplanar : CutKind::none};
  }
  if (zeros == 2) {
    const auto off = static_cast<std::size_t>(
        std::find_if(sides.begin(), sides.end(), [](Sign side) { return side != Sign::zero; }) -
        sides.begin());
    const auto q = corners_of(s);
    const std::size_t edge = (off + 1) % 3;
    if (is_corner(q[edge], t) && is_corner(q[(edge + 1) % 3], t)) {
      return {};
    }
    return {sides[off] == Sign::positive ? CutKind::above : CutKind::below, edge};
  }
  const auto back = sides_of(s, t, predicates);
  const bool crosses = count_of(back, Sign::positive) != 3 && count_of(back, Sign::negative) != 3;
  return {crosses ? CutKind::across : CutKind::none};
}

bool may_share_area(const Triangle& t, const Triangle& s, Predicates& predicates) {
  return is_coplanar(t, s, predicates) && share_area(t, s, predicates);
}

}  // namespace soms::detail
