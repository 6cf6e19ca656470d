#include "soms/query/detail/solid/solid_regions.h"

#include "soms/geometry/detail/exact/predicates.h"
#include "soms/query/detail/solid/planar_triangles.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

/// Of so few coplanar triangles all are tried at each point; of more, those that a search finds.
constexpr std::size_t kFewCoplanar = 8;

/// So many triangles or edges are looked at between two questions whether to stop.
constexpr std::size_t kBetweenStops = 256;

bool by_id(const MovedTriangle& s, const MovedTriangle& t) {
  return s.id < t.id;
}

}  // namespace

Relation SolidRegions::relation(bool surfaces_meet) const {
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

RegionSearch::Cutting RegionSearch::cutting_of(const CellPlane& plane, const Triangle& t,
                                               std::size_t body, TriangleId id, bool both) {
  const std::size_t other = 1 - body;
  Cutting cutting;
  add_cuts(plane, t, body, id, cutting);
  if (both) {
    add_cuts(plane, t, other, std::nullopt, cutting);
  }
  for (std::vector<MovedTriangle>& coplanar : cutting.coplanar) {
    std::sort(coplanar.begin(), coplanar.end(), by_id);
  }
  Predicates predicates;
  std::size_t looked_at = 0;
  for (const PlanarEdge& edge : cutting.edges.odd()) {
    if (++looked_at % kBetweenStops == 0 && stopped()) {
      break;
    }
    if (plane.may_part(edge.from, edge.to, predicates)) {
      ++cost_.exact_tests;
      cutting.cuts.push_back(plane.cut_between(edge.from, edge.to));
    }
  }
  return cutting;
}

void RegionSearch::add_cuts(const CellPlane& plane, const Triangle& t, std::size_t body,
                            std::optional<TriangleId> but, Cutting& cutting) {
  searches_[body].find(bounds(t), near_, cost_);
  Predicates predicates;
  std::size_t looked_at = 0;
  for (const MovedTriangle& other : near_) {
    if (++looked_at % kBetweenStops == 0 && stopped()) {
      return;
    }
    if (other.id == but) {
      continue;
    }
    const auto& [a, b, c] = other.triangle;
    const std::array<Vec3, 3> corners{a, b, c};
    const TriangleCut cut = cut_of(t, other.triangle, predicates);
    if (cut.kind == CutKind::across) {
      ++cost_.exact_tests;
      plane.seen(other.triangle).append_cuts(cutting.cuts);
    } else if (cut.kind == CutKind::coplanar) {
      for (std::size_t i = 0; i < 3; ++i) {
        cutting.edges.add(corners[i], corners[(i + 1) % 3], body, cut.kind);
      }
      cutting.coplanar[body].push_back(other);
    } else if (cut.kind != CutKind::none) {
      cutting.edges.add(corners[cut.edge], corners[(cut.edge + 1) % 3], body, cut.kind);
    }
  }
}

bool RegionSearch::odd(const CellPlane& plane, const PlanePoint& p, std::size_t body,
                       const Cutting& cutting) {
  const std::vector<MovedTriangle>& all = cutting.coplanar[body];
  const bool few = all.size() <= kFewCoplanar;
  const Box ray = plane.ray_box(p);
  if (!few) {
    searches_[body].find(ray, near_, cost_);
  }
  bool odd = false;
  for (const MovedTriangle& other : few ? all : near_) {
    const bool candidate = few || std::binary_search(all.begin(), all.end(), other, by_id);
    if (candidate && plane.may_cover(other.triangle, ray)) {
      ++cost_.exact_tests;
      odd = odd != plane.seen(other.triangle).covers(p);
    }
  }
  return odd;
}

bool RegionSearch::inside_above(const CellPlane& plane, const PlanePoint& p, std::size_t body) {
  const Box ray = plane.ray_box(p);
  searches_[body].find(ray, near_, cost_);
  Predicates predicates;
  bool odd = false;
  for (const MovedTriangle& other : near_) {
    if (plane.may_cover(other.triangle, ray) && !plane.has_below(other.triangle, predicates)) {
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
  const Cutting cutting = cutting_of(*plane, t, body, id, true);
  plane->for_each_cell_in_boxes(cutting.cuts, [&](const PlanePoint& p) {
    if (stopped()) {
      return false;
    }
    if (odd(*plane, p, body, cutting)) {  // with the triangle itself an even number
      met_idle_[body] = true;
    } else if (!odd(*plane, p, other, cutting)) {
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
  const Cutting cutting = cutting_of(*plane, t, body, id, false);
  bool late = false;
  const bool found = !plane->for_each_cell_in_boxes(cutting.cuts, [&](const PlanePoint& p) {
    late = stopped();
    return !late && odd(*plane, p, body, cutting);
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
