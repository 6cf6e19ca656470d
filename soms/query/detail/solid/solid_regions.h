/// \file
/// Which of three regions of space two bodies have: shared interior, and what is in one only.
///
/// What is searched for. Inside and outside of both bodies part space into regions, of which all
/// but the one that is outside of both are bounded. A region of points inside a and outside b, say,
/// has a boundary, and across any generic point of it one body changes sides: that point lies on an
/// odd number of triangles of that body. So it suffices to look at both sides of each triangle,
/// cell by cell, wherever a body has an odd number of triangles in one place:
///  - odd of one body, even of the other: the other body is on one side of the cell what it is on
///    the other; both regions beside the cell are known from one ray.
///  - odd of both: two rays tell one side, and on the other both have changed.
/// Cells are cut by the other body's triangles, and by the own body's, since either may change what
/// is seen beside the triangle.
///
/// An edge in the plane of the triangle cuts it only where it parts something. What changes across
/// it is, of each body, whether the number of coplanar triangles is odd, and whether the ray
/// crosses an odd number of others: each coplanar triangle along the edge changes the first, and
/// each triangle that stands on the edge above the plane the second. Two that have the very same
/// edge change nothing together. So the inner edges of a face of many triangles cut nothing.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/parts/plane_cells.h"
#include "soms/query/answer.h"
#include "soms/query/detail/solid/box_search.h"
#include "soms/query/detail/solid/edge_sums.h"
#include "soms/query/solid.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace soms::detail {

/// Regions that were seen.
struct SolidRegions {
  bool both = false;
  std::array<bool, 2> only = {};  ///< of a, of b

  void add(bool in_a, bool in_b) {
    both = both || (in_a && in_b);
    only[0] = only[0] || (in_a && !in_b);
    only[1] = only[1] || (in_b && !in_a);
  }

  /// Both sides of a surface of body `of` where the other body is `in_other`.
  void add_sides(std::size_t of, bool in_other) {
    add(of == 0 || in_other, of == 1 || in_other);
    add(of == 1 && in_other, of == 0 && in_other);
  }

  /// What they make of two bodies, if there are no others.
  [[nodiscard]] Relation relation(bool surfaces_meet) const;

  [[nodiscard]] bool operator==(const SolidRegions&) const = default;

  /// Nothing more can be seen.
  [[nodiscard]] bool all() const { return both && only[0] && only[1]; }
};

/// Looks at triangles of two bodies. Refers to the bodies.
class RegionSearch {
 public:
  /// `stop`, if any, is called at each cell and between a few hundred triangles; once it is true,
  /// it has to stay so, and nothing that was looked at counts.
  RegionSearch(const Body& a, const Body& b, std::function<bool()> stop = {});

  [[nodiscard]] Triangle moved(std::size_t body, TriangleId id) const {
    return searches_[body].moved(id);
  }

  /// Looks at all cells of a triangle, until all regions were seen.
  void look_at(std::size_t body, TriangleId id, SolidRegions& regions);

  /// True if somewhere on the triangle its body has an odd number of triangles.
  [[nodiscard]] bool bounds_anything(std::size_t body, TriangleId id);

  /// True if it has area, and surely no other triangle of its body has a part of it in common.
  [[nodiscard]] bool stands_alone(std::size_t body, TriangleId id);

  /// A triangle that was looked at is without area, or has cells where its body has an even number
  /// of triangles.
  [[nodiscard]] bool met_idle(std::size_t body) const { return met_idle_[body]; }

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  /// What may cut a triangle, and what lies on it.
  struct Cutting {
    std::vector<PlaneCut> cuts;
    EdgeSums edges;
    std::array<std::vector<MovedTriangle>, 2> coplanar;  // by body; of its own, the others
  };

  /// The cuts of triangle `id` of `body`, by its own body and, if `both`, by the other. Some are
  /// missing once it is time to stop.
  [[nodiscard]] Cutting cutting_of(const CellPlane& plane, const Triangle& t, std::size_t body,
                                   TriangleId id, bool both);

  /// Adds what the triangles of `body` near `t` cut of it, other than number `but`.
  void add_cuts(const CellPlane& plane, const Triangle& t, std::size_t body,
                std::optional<TriangleId> but, Cutting& cutting);

  /// Whether an odd number of coplanar triangles of a body covers the point.
  [[nodiscard]] bool odd(const CellPlane& plane, const PlanePoint& p, std::size_t body,
                         const Cutting& cutting);

  /// Whether a body is on that side of the plane to which the ray from the point goes.
  [[nodiscard]] bool inside_above(const CellPlane& plane, const PlanePoint& p, std::size_t body);

  [[nodiscard]] bool stopped() const { return stop_ && stop_(); }

  std::array<BoxSearch, 2> searches_;
  std::function<bool()> stop_;
  std::array<bool, 2> met_idle_ = {};
  std::vector<MovedTriangle> near_;
  Cost cost_;
};

}  // namespace soms::detail
