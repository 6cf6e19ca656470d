#include "soms/clash/detail/pair_of_parts.h"

#include "soms/clash/detail/clash_kind.h"
#include "soms/clash/detail/open_parts.h"
#include "soms/geometry/contact_box.h"
#include "soms/query/contains.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/solid.h"
#include "soms/scene/detail/contact_place.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr double kAnyGap = std::numeric_limits<double>::infinity();

/// The pairs of triangles that meet, where poses have moved them.
std::vector<std::pair<Triangle, Triangle>> moved_pairs(const Body& a, const Body& b,
                                                       std::span<const TrianglePair> pairs) {
  std::vector<std::pair<Triangle, Triangle>> triangles;
  triangles.reserve(pairs.size());
  for (const TrianglePair& pair : pairs) {
    triangles.emplace_back(moved_triangle(a, pair.a), moved_triangle(b, pair.b));
  }
  return triangles;
}

/// Where the surfaces of two parts meet, by all pairs of triangles that do.
void place_contact(std::span<const std::pair<Triangle, Triangle>> pairs, Clash& clash) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    grow_by_contact(clash.box, k, pairs[k].first, pairs[k].second);
  }
  clash.triangle_pairs = pairs.size();
  clash.place = contact_place(pairs).point;
}

/// A vertex of `inner`, and the box around it all.
void place_inside(const PartBody& inner, Clash& clash) {
  clash.place = inner.components.front().corner;
  clash.box = inner.box();
}

/// An order of parts that does not depend on their numbers: the contact of many triangles, and the
/// nearest points of parallel faces, have a place each, which must not change with the order.
bool comes_first(const Body& a, const Body& b) {
  const auto place = [](const Body& body) {
    const Box box = body.shape.bounds();
    return std::tuple(box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z,
                      body.shape.mesh().triangles.size(), body.pose.m);
  };
  const auto of_a = place(a);
  const auto of_b = place(b);
  return of_a != of_b ? of_a < of_b : corner_hash(a.shape.mesh()) < corner_hash(b.shape.mesh());
}

std::optional<Penetration> penetration_of(const PartBody& a, const PartBody& b) {
  const std::optional<ConvexPart> convex_a = ConvexPart::of(a);
  const std::optional<ConvexPart> convex_b = convex_a ? ConvexPart::of(b) : std::nullopt;
  return convex_b ? penetration(*convex_a, *convex_b) : std::nullopt;
}

}  // namespace

bool PairOfParts::meet(const Body& a, const Body& b, bool open, Clash& clash) {
  const Overlap met = counted(overlap(a, b, {}, alone_));
  if (!met.any || cut_) {
    return false;
  }
  const auto pairs = moved_pairs(a, b, met.pairs);
  place_contact(pairs, clash);
  return open && surfaces_cross(met.pairs, pairs);
}

bool PairOfParts::measure(const Body& a, const Body& b, double at_most, Clash& clash) {
  const Distance gap = counted(distance(a, b, {.at_most = at_most}, alone_));
  if (gap.farther || cut_) {
    return false;
  }
  clash.gap = gap.distance;
  clash.box.grow(gap.point_a);
  clash.box.grow(gap.point_b);
  clash.place = clash.box.center();
  return true;
}

std::optional<Clash> PairOfParts::of_clear(const Body& a, const Body& b, Clash clash) {
  if (!options_.within || !measure(a, b, *options_.within, clash)) {
    return std::nullopt;
  }
  clash.kind = ClashKind::near;
  clash.relation = Relation::clear;
  return clash;
}

std::optional<Clash> PairOfParts::decide(const PartBody& a, const PartBody& b) {
  cut_ = false;
  std::optional<Clash> clash = decide_parts(a, b);
  const bool is_clash = clash && clash->kind != ClashKind::near;
  if (cut_ || is_clash || !lead_bodies(a, b)) {
    return clash;
  }
  std::optional<Clash> of_bodies = of_led_bodies(a, b);
  return cut_ ? std::nullopt : of_bodies ? of_bodies : clash;
}

std::optional<Clash> PairOfParts::decide_parts(const PartBody& a, const PartBody& b) {
  if (!comes_first(b.body, a.body)) {
    return decide_in_order(a, b);
  }
  std::optional<Clash> clash = decide_in_order(b, a);
  if (clash && clash->kind == ClashKind::inside) {
    clash->relation = clash->relation == Relation::a_in_b ? Relation::b_in_a : Relation::a_in_b;
  }
  if (clash && clash->penetration) {
    clash->penetration->direction = -clash->penetration->direction;
  }
  return clash;
}

std::optional<Clash> PairOfParts::of_led_bodies(const PartBody& a, const PartBody& b) {
  const PartBody& whole_a = body_led_by(a);
  const PartBody& whole_b = body_led_by(b);
  if (comes_first(whole_b.body, whole_a.body)) {
    return of_led_bodies(b, a);
  }
  // Where surfaces meet, those of two parts do; where one is in what is closed, a part is; and what
  // a part that is open alone may hold is of that part's pairs.
  if (meet_anywhere(whole_a.body, whole_b.body) ||
      relation_of_apart(whole_a, whole_b) != Relation::clear) {
    return std::nullopt;
  }
  const bool may_hold = (a.together.body && may_be_inside(whole_b, whole_a)) ||
                        (b.together.body && may_be_inside(whole_a, whole_b));
  if (cut_ || !may_hold) {
    return std::nullopt;
  }
  Clash clash{.why = Undecided::open};
  measure(whole_a.body, whole_b.body, kAnyGap, clash);
  return clash;
}

bool PairOfParts::meet_anywhere(const Body& a, const Body& b) {
  return counted(overlap(a, b, {.mode = OverlapMode::any}, alone_)).any;
}

Relation PairOfParts::relation_to_closed(const PartBody& part, const ClosedBody& closed,
                                         Relation all_inside) {
  std::size_t inside = 0;
  for (const PartComponent& component : part.components) {
    const Contains answer = counted(contains(closed, component.corner, alone_));
    inside += answer.side == Side::inside ? 1 : 0;
  }
  return inside == 0                        ? Relation::clear
         : inside == part.components.size() ? all_inside
                                            : Relation::crossing;
}

bool PairOfParts::may_be_inside(const PartBody& inner, const PartBody& outer) {
  return fits_into(inner, outer) || meet_anywhere(inner.body, outer.caps);
}

Relation PairOfParts::relation_of_apart(const PartBody& a, const PartBody& b) {
  return a.closed   ? relation_to_closed(b, *a.closed, Relation::b_in_a)
         : b.closed ? relation_to_closed(a, *b.closed, Relation::a_in_b)
                    : Relation::clear;
}

std::optional<Clash> PairOfParts::of_open(const PartBody& a, const PartBody& b) {
  Clash clash;
  const bool through = meet(a.body, b.body, true, clash);
  if (cut_) {
    return std::nullopt;
  }
  if (clash.triangle_pairs != 0) {
    clash.relation = through ? Relation::crossing : Relation::undecided;
  } else {
    clash.relation = relation_of_apart(a, b);
    const bool in_closed = clash.relation == Relation::a_in_b || clash.relation == Relation::b_in_a;
    // The open one may go around a cavity of the other.
    if (in_closed && (a.closed ? fits_into(a, b) : fits_into(b, a))) {
      clash.relation = Relation::undecided;
    }
    if (clash.relation == Relation::clear &&
        ((!b.closed && may_be_inside(a, b)) || (!a.closed && may_be_inside(b, a)))) {
      clash.relation = Relation::undecided;
    }
    if (cut_ || clash.relation == Relation::clear) {
      return cut_ ? std::nullopt : of_clear(a.body, b.body, clash);
    }
    measure(a.body, b.body, kAnyGap, clash);
  }
  clash.kind = kind_of(clash.relation);
  if (clash.kind == ClashKind::inside) {
    place_inside(clash.relation == Relation::a_in_b ? a : b, clash);
  }
  if (clash.kind == ClashKind::undecided) {
    clash.why = Undecided::open;
  }
  return clash;
}

std::optional<Clash> PairOfParts::decide_in_order(const PartBody& a, const PartBody& b) {
  if (!a.closed || !b.closed) {
    return of_open(a, b);
  }
  Clash clash;
  const Solid answer = counted(solid(*a.closed, *b.closed, alone_));
  if (cut_) {
    return std::nullopt;
  }
  if (answer.relation == Relation::clear) {
    return of_clear(a.body, b.body, clash);
  }
  clash.relation = answer.relation;
  clash.kind = kind_of(answer.relation);
  if (answer.surfaces_meet) {
    meet(a.body, b.body, false, clash);
  } else {
    measure(a.body, b.body, kAnyGap, clash);
    if (clash.kind == ClashKind::inside) {
      place_inside(answer.relation == Relation::a_in_b ? a : b, clash);
    }
  }
  if (clash.kind != ClashKind::touching) {
    clash.penetration = penetration_of(a, b);
  }
  return clash;
}

}  // namespace soms::detail
