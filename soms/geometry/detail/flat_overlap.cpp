#include "soms/geometry/detail/flat_overlap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace soms::detail {

namespace {

/// The corners that a triangle comes down to: all three, the two ends of a segment, or one point.
struct Simplex {
  std::array<Vec3, 3> corners;
  std::size_t count;
  Projection plane;  ///< where a proper triangle has area

  [[nodiscard]] std::span<const Vec3> points() const { return {corners.data(), count}; }
};

bool lexicographically_less(const Vec3& p, const Vec3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

/// Coordinate planes, the one that a triangle's normal is steepest on first: quickest to confirm.
std::array<Projection, 3> planes_by_area(const Triangle& t) {
  const Vec3 n = cross(t.b - t.a, t.c - t.a);
  std::array planes{Projection::yz, Projection::zx, Projection::xy};
  const double x = std::abs(n.x);
  const double y = std::abs(n.y);
  const double z = std::abs(n.z);
  if (y > x && y >= z) {
    std::swap(planes[0], planes[1]);
  } else if (z > x && z > y) {
    std::swap(planes[0], planes[2]);
  }
  return planes;
}

Simplex simplex_of(const Triangle& t, Predicates& predicates) {
  const std::array<Vec3, 3> corners{t.a, t.b, t.c};
  for (const Projection plane : planes_by_area(t)) {
    if (predicates.orientation2d(t.a, t.b, t.c, plane) != Sign::zero) {
      return {corners, 3, plane};
    }
  }
  // Collinear: on a line, lexicographic order is the order along it.
  const auto [first, last] =
      std::minmax_element(corners.begin(), corners.end(), lexicographically_less);
  const std::size_t count = *first == *last ? 1 : 2;
  return {{*first, *last, *last}, count, Projection::xy};
}

/// True if the line through p and q, in the plane, has all of `these` strictly on one side and none
/// of `those` strictly on that side.
bool line_separates(const Vec3& p, const Vec3& q, std::span<const Vec3> these,
                    std::span<const Vec3> those, Projection plane, Predicates& predicates) {
  const Sign side = predicates.orientation2d(p, q, these[0], plane);
  if (side == Sign::zero) {
    return false;
  }
  for (const Vec3& r : these.subspan(1)) {
    if (predicates.orientation2d(p, q, r, plane) != side) {
      return false;
    }
  }
  return std::none_of(those.begin(), those.end(), [&](const Vec3& r) {
    return predicates.orientation2d(p, q, r, plane) == side;
  });
}

/// True if the line of an edge of `s` keeps `t` strictly off `s`.
bool edge_separates(const Simplex& s, const Simplex& t, Projection plane, Predicates& predicates) {
  const std::size_t edges = s.count == 3 ? 3 : s.count - 1;
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t j = (i + 1) % s.count;
    const std::size_t k = (i + 2) % s.count;
    const std::span<const Vec3> rest =
        s.count == 3 ? std::span(&s.corners[k], 1) : std::span<const Vec3>();
    if (line_separates(s.corners[i], s.corners[j], t.points(), rest, plane, predicates)) {
      return true;
    }
  }
  return false;
}

/// A triangle with area and anything in its plane: two convex sets in a plane are disjoint only if
/// the line of an edge of one of them separates them.
bool coplanar_overlap(const Simplex& triangle, const Simplex& other, Predicates& predicates) {
  return !edge_separates(triangle, other, triangle.plane, predicates) &&
         !edge_separates(other, triangle, triangle.plane, predicates);
}

/// Product of signs: the sign of the product.
int times(Sign a, Sign b) {
  return static_cast<int>(a) * static_cast<int>(b);
}

bool triangle_meets_segment(const Simplex& triangle, const Simplex& segment,
                            Predicates& predicates) {
  const auto& [a, b, c] = triangle.corners;
  const Vec3& p = segment.corners[0];
  const Vec3& q = segment.corners[1];
  const Sign above = predicates.orientation(a, b, c, p);
  const Sign below = predicates.orientation(a, b, c, q);
  if (above == Sign::zero && below == Sign::zero) {
    return coplanar_overlap(triangle, segment, predicates);
  }
  if (times(above, below) > 0) {
    return false;
  }
  const Sign ab = predicates.orientation(p, q, a, b);
  const Sign bc = predicates.orientation(p, q, b, c);
  const Sign ca = predicates.orientation(p, q, c, a);
  return times(ab, bc) >= 0 && times(bc, ca) >= 0 && times(ca, ab) >= 0;
}

bool triangle_holds_point(const Simplex& triangle, const Simplex& point, Predicates& predicates) {
  const auto& [a, b, c] = triangle.corners;
  return predicates.orientation(a, b, c, point.corners[0]) == Sign::zero &&
         !edge_separates(triangle, point, triangle.plane, predicates);
}

/// Overlap of two segments seen in one plane; nothing if all four ends are collinear there.
std::optional<bool> segments_meet_in(Projection plane, const Simplex& s, const Simplex& t,
                                     Predicates& predicates) {
  const auto turn = [&](const Simplex& line, const Vec3& p) {
    return predicates.orientation2d(line.corners[0], line.corners[1], p, plane);
  };
  const Sign t0 = turn(s, t.corners[0]);
  const Sign t1 = turn(s, t.corners[1]);
  const Sign s0 = turn(t, s.corners[0]);
  const Sign s1 = turn(t, s.corners[1]);
  if (t0 == Sign::zero && t1 == Sign::zero && s0 == Sign::zero && s1 == Sign::zero) {
    return std::nullopt;
  }
  return times(t0, t1) <= 0 && times(s0, s1) <= 0;
}

bool segments_meet(const Simplex& s, const Simplex& t, Predicates& predicates) {
  if (predicates.orientation(s.corners[0], s.corners[1], t.corners[0], t.corners[1]) !=
      Sign::zero) {
    return false;
  }
  // Coplanar. A projection in which the ends are not collinear maps their plane one to one.
  for (const Projection plane : {Projection::xy, Projection::yz, Projection::zx}) {
    if (const auto answer = segments_meet_in(plane, s, t, predicates)) {
      return *answer;
    }
  }
  return !lexicographically_less(s.corners[1], t.corners[0]) &&
         !lexicographically_less(t.corners[1], s.corners[0]);
}

bool segment_holds_point(const Simplex& segment, const Vec3& p, Predicates& predicates) {
  const Vec3& first = segment.corners[0];
  const Vec3& last = segment.corners[1];
  for (const Projection plane : {Projection::xy, Projection::yz, Projection::zx}) {
    if (predicates.orientation2d(first, last, p, plane) != Sign::zero) {
      return false;
    }
  }
  return !lexicographically_less(p, first) && !lexicographically_less(last, p);
}

}  // namespace

bool flat_overlap(const Triangle& s, const Triangle& t, Predicates& predicates) {
  Simplex high = simplex_of(s, predicates);
  Simplex low = simplex_of(t, predicates);
  if (high.count < low.count) {
    std::swap(high, low);
  }
  if (high.count == 3) {
    return low.count == 3   ? coplanar_overlap(high, low, predicates)
           : low.count == 2 ? triangle_meets_segment(high, low, predicates)
                            : triangle_holds_point(high, low, predicates);
  }
  if (high.count == 2) {
    return low.count == 2 ? segments_meet(high, low, predicates)
                          : segment_holds_point(high, low.corners[0], predicates);
  }
  return high.corners[0] == low.corners[0];
}

}  // namespace soms::detail
