#include "soms/query/detail/solid/solid_regions.h"

#include "soms/geometry/detail/predicates.h"
#include "soms/query/detail/solid/planar_triangles.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace soms::detail {

soms::Relation SolidRegions::relation(bool surfaces_meet) const {
  if (!both) {
    return surfaces_meet ? soms::Relation::touching : soms::Relation::clear;
  }
  if (only[0]) {
    return only[1] ? soms::Relation::crossing : soms::Relation::b_in_a;
  }
  return only[1] ? soms::Relation::a_in_b : soms::Relation::same;
}

RegionSearch::RegionSearch(const Body& a, const Body& b, std::function<bool()> stop)
    : searches_{BoxSearch(a), BoxSearch(b)}, stop_(std::move(stop)) {
}

bool RegionSearch::Cutting::odd(std::size_t body, const PlanePoint& p) const {
  return std::count_if(coplanar[body].begin(), coplanar[body].end(),
                       [&](const SeenTriangle& s) { return s.covers(p); }) %
             2 !=
         0;
}

void RegionSearch::add_cuts(const CellPlane& plane, const Triangle& t, std::size_t body,
                            std::optional<TriangleId> but, Cutting& cutting) {
  searches_[body].find(bounds(t), near_, cost_);
  Predicates predicates;
  for (const MovedTriangle& other : near_) {
    if (other.id == but || !may_cut(t, other.triangle, predicates)) {
      continue;
    }
    ++cost_.exact_tests;
    SeenTriangle seen = plane.seen(other.triangle);
    seen.append_cuts(cutting.cuts);
    if (!seen.flat() && seen.coplanar()) {
      cutting.coplanar[body].push_back(std::move(seen));
    }
  }
}

bool RegionSearch::inside_above(const CellPlane& plane, const PlanePoint& p, std::size_t body) {
  searches_[body].find(plane.ray_box(p), near_, cost_);
  Predicates predicates;
  bool odd = false;
  for (const MovedTriangle& other : near_) {
    if (!plane.has_below(other.triangle, predicates)) {
      ++cost_.exact_tests;
      odd = odd != plane.seen(other.triangle).is_above(p);
    }
  }
  return odd;
}

void RegionSearch::look_at(std::size_t body, TriangleId id, SolidRegions& regions) {
  const std::size_t other = 1 - body;
  const Triangle t = moved(body, id);
  const std::optional<CellPlane> plane = CellPlane::of(t, CellPlane::View::steep);
  if (!plane) {
    met_idle_[body] = true;
    return;
  }
  Cutting cutting;
  add_cuts(*plane, t, body, id, cutting);
  add_cuts(*plane, t, other, std::nullopt, cutting);
  plane->for_each_cell(cutting.cuts, [&](const PlanePoint& p) {
    if (stopped()) {
      return false;
    }
    if (cutting.odd(body, p)) {  // with the triangle itself an even number
      met_idle_[body] = true;
    } else if (!cutting.odd(other, p)) {
      regions.add_sides(body, inside_above(*plane, p, other));
    } else if (body == 0) {  // the same cell of b would tell the same
      const bool in_a = inside_above(*plane, p, 0);
      const bool in_b = inside_above(*plane, p, 1);
      regions.add(in_a, in_b);
      regions.add(!in_a, !in_b);
    }
    return !regions.all();
  });
}

bool RegionSearch::bounds_anything(std::size_t body, TriangleId id) {
  if (stands_alone(body, id)) {
    return true;
  }
  const Triangle t = moved(body, id);
  const std::optional<CellPlane> plane = CellPlane::of(t, CellPlane::View::steep);
  if (!plane) {
    return false;
  }
  Cutting cutting;
  add_cuts(*plane, t, body, id, cutting);
  bool late = false;
  const bool found = !plane->for_each_cell(cutting.cuts, [&](const PlanePoint& p) {
    late = stopped();
    return !late && cutting.odd(body, p);
  });
  return found && !late;
}

bool RegionSearch::stands_alone(std::size_t body, TriangleId id) {
  const Triangle t = moved(body, id);
  Predicates predicates;
  if (!has_area(t, predicates)) {
    return false;
  }
  searches_[body].find_beside(id, near_, cost_);
  return std::none_of(near_.begin(), near_.end(), [&](const MovedTriangle& other) {
    return other.id != id && may_share_area(t, other.triangle, predicates);
  });
}

}  // namespace soms::detail
