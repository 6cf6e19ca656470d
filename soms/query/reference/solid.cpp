#include "soms/query/reference/solid.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/plane_cells.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/reference/detail/moved_triangles.h"
#include "soms/query/reference/overlap.h"

#include <array>
#include <utility>
#include <vector>

namespace soms::reference {

namespace {

using soms::detail::CellPlane;
using soms::detail::PlaneCut;
using soms::detail::PlanePoint;
using soms::detail::SeenTriangle;

/// All triangles of both bodies, and what was seen beside their cells.
class SolidScan {
 public:
  SolidScan(const Body& a, const Body& b)
      : triangles_{detail::moved_triangles(a.shape.mesh(), a.pose),
                   detail::moved_triangles(b.shape.mesh(), b.pose)} {}

  [[nodiscard]] Relation relation(bool surfaces_meet, const Limits& limits) {
    for (const auto& triangles : triangles_) {
      for (const Triangle& t : triangles) {
        check(limits);
        if (const auto plane = CellPlane::of(t, CellPlane::View::shallow)) {
          scan(*plane, t);
        }
      }
    }
    if (!seen_[1][1]) {
      return surfaces_meet ? Relation::touching : Relation::clear;
    }
    return seen_[1][0] ? (seen_[0][1] ? Relation::crossing : Relation::b_in_a)
                       : (seen_[0][1] ? Relation::a_in_b : Relation::same);
  }

 private:
  void scan(const CellPlane& plane, const Triangle& t) {
    std::vector<PlaneCut> cuts;
    std::array<std::vector<SeenTriangle>, 2> coplanar;
    for (std::size_t body = 0; body < 2; ++body) {
      for (const Triangle& s : triangles_[body]) {
        if (!overlaps(bounds(s), bounds(t)) || !triangles_overlap(s, t)) {
          continue;
        }
        SeenTriangle seen = plane.seen(s);
        seen.append_cuts(cuts);
        if (!seen.flat() && seen.coplanar()) {
          coplanar[body].push_back(std::move(seen));
        }
      }
    }
    plane.for_each_cell(cuts, [&](const PlanePoint& p) {
      std::array<std::array<bool, 2>, 2> inside;  // body, side
      for (std::size_t body = 0; body < 2; ++body) {
        inside[body][0] = is_inside(plane, p, body);
        inside[body][1] = inside[body][0];
        for (const SeenTriangle& s : coplanar[body]) {
          inside[body][1] = inside[body][1] != s.covers(p);
        }
      }
      seen_[inside[0][0] ? 1 : 0][inside[1][0] ? 1 : 0] = true;
      seen_[inside[0][1] ? 1 : 0][inside[1][1] ? 1 : 0] = true;
      return true;
    });
  }

  /// On the side to which rays go.
  [[nodiscard]] bool is_inside(const CellPlane& plane, const PlanePoint& p,
                               std::size_t body) const {
    const Box ray = plane.ray_box(p);
    bool odd = false;
    for (const Triangle& s : triangles_[body]) {
      odd = odd != (overlaps(bounds(s), ray) && plane.seen(s).is_above(p));
    }
    return odd;
  }

  std::array<std::vector<Triangle>, 2> triangles_;
  std::array<std::array<bool, 2>, 2> seen_{};  // in a, in b
};

}  // namespace

Solid solid_by_brute_force(const Body& a, const Body& b, const Limits& limits) {
  const PlainArithmetic plain;
  SolidScan scan(a, b);
  Solid answer;
  answer.surfaces_meet =
      overlap(a.shape.mesh(), a.pose, b.shape.mesh(), b.pose, {.stop = limits.stop}).any;
  answer.relation = scan.relation(answer.surfaces_meet, limits);
  return answer;
}

}  // namespace soms::reference
