#include "soms/query/detail/self/neighbor_overlap.h"

#include "soms/geometry/orientation.h"
#include "soms/geometry/triangle_overlap.h"

#include <array>

namespace soms::detail {

namespace {

constexpr std::array<Projection, 3> kProjectionsOfNeighbors{Projection::xy, Projection::yz,
                                                            Projection::zx};

bool same_side(Sign a, Sign b) {
  return a == b && a != Sign::zero;
}

bool is_segment(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (const Projection plane : kProjectionsOfNeighbors) {
    if (orientation2d(a, b, c, plane) != Sign::zero) {
      return false;
    }
  }
  return true;
}

Triangle point_triangle(const Vec3& p) {
  return {p, p, p};
}

Triangle segment_triangle(const Vec3& p, const Vec3& q) {
  return {p, q, q};
}

bool on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  return triangles_overlap(point_triangle(p), segment_triangle(a, b));
}

/// Whether the segment from v to p shares a point other than v with the triangle (v, r, s), which
/// has area: it leaves that at p or through the edge from r to s, if it enters at all.
bool segment_beyond_corner(const Vec3& v, const Vec3& p, const Vec3& r, const Vec3& s) {
  return p != v && (triangles_overlap(point_triangle(p), {v, r, s}) ||
                    triangles_overlap(segment_triangle(v, p), segment_triangle(r, s)));
}

/// Whether two segments from v share another point.
bool segments_beyond_corner(const Vec3& v, const Vec3& p, const Vec3& r) {
  return p != v && r != v && (on_segment(p, v, r) || on_segment(r, v, p));
}

}  // namespace

// What lies between v and a point that both triangles have, both have. So one of them ends at a
// point that the other has, too: on the edge opposite v, where the triangle has area.
bool share_beyond_corner(const Vec3& v, const Vec3& p, const Vec3& q, const Vec3& r,
                         const Vec3& s) {
  if (same_side(orientation(v, p, q, r), orientation(v, p, q, s)) ||
      same_side(orientation(v, r, s, p), orientation(v, r, s, q))) {
    return false;
  }
  const bool first_is_segment = is_segment(v, p, q);
  const bool second_is_segment = is_segment(v, r, s);
  if (first_is_segment && second_is_segment) {
    return segments_beyond_corner(v, p, r) || segments_beyond_corner(v, p, s) ||
           segments_beyond_corner(v, q, r) || segments_beyond_corner(v, q, s);
  }
  if (first_is_segment) {
    return segment_beyond_corner(v, p, r, s) || segment_beyond_corner(v, q, r, s);
  }
  if (second_is_segment) {
    return segment_beyond_corner(v, r, p, q) || segment_beyond_corner(v, s, p, q);
  }
  return triangles_overlap(segment_triangle(p, q), {v, r, s}) ||
         triangles_overlap(segment_triangle(r, s), {v, p, q});
}

bool share_beyond_edge(const Vec3& u, const Vec3& v, const Vec3& p, const Vec3& r) {
  if (u == v) {
    return segments_beyond_corner(u, p, r);
  }
  if (orientation(u, v, p, r) != Sign::zero) {
    return false;
  }
  for (const Projection plane : kProjectionsOfNeighbors) {
    const Sign side = orientation2d(u, v, p, plane);
    const Sign other = orientation2d(u, v, r, plane);
    if (side != Sign::zero || other != Sign::zero) {
      // One plane holds both, and this projection keeps it apart.
      return side == other;
    }
  }
  // All four are on one line: beyond the same end.
  return !on_segment(p, u, v) && !on_segment(r, u, v) &&
         (on_segment(p, v, r) || on_segment(r, v, p));
}

}  // namespace soms::detail
