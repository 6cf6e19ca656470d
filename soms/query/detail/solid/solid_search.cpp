#include "soms/query/detail/solid/solid_search.h"

#include "soms/query/detail/closed_surface.h"
#include "soms/query/detail/engine/batch.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/solid/quarter_points.h"
#include "soms/query/detail/solid/solid_regions.h"
#include "soms/query/overlap.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

namespace {

/// What a look at a triangle costs, in the tests that `Limit` counts.
constexpr std::uint64_t kWorkOfLook = 2000;

/// So many triangles in contact show their corners before any is cut into cells, which costs as
/// much as hundreds of points.
constexpr std::size_t kFewTriangles = 16;

/// Triangles that overlap nothing of the other body, one at least of each set of them that hangs
/// together, and the side of the other body on which each one lies.
struct LooseTriangles {
  std::vector<TriangleId> ids;
  std::vector<Side> sides;
};

/// Steps from what is quick to what is not, until all regions are seen or nothing is left.
class SolidSearch {
 public:
  SolidSearch(const ClosedBody& a, const ClosedBody& b, const Limits& limits)
      : bodies_{&a, &b},
        search_(a.body(), b.body(),
                [this] {
                  late_ = late_ || limit_.spend(kWorkOfLook);
                  return late_;
                }),
        limits_(limits),
        limit_(limits) {}

  /// False where the deadline passed.
  [[nodiscard]] bool run(const std::optional<TrianglePair>& contact) {
    if (contact) {
      look_at_corners(0, {&contact->a, 1});
      look_at_corners(1, {&contact->b, 1});
      look_at_quarters(*contact);
      if (!regions_.all() && !late_) {
        look_at_contacts();
      }
    }
    if (!regions_.all() && !late_) {
      look_at_rest();
    }
    return !late_;
  }

  [[nodiscard]] const SolidRegions& regions() const { return regions_; }

  [[nodiscard]] Cost cost() const {
    Cost cost = cost_;
    cost += search_.cost();
    return cost;
  }

 private:
  /// Counts work; true when it is time to stop.
  bool stop() {
    late_ = late_ || limit_.spend(kWorkOfLook);
    return late_ || regions_.all();
  }

  /// Sides of the other body on which points of `body` lie.
  std::vector<Side> sides_of(std::size_t body, std::span<const Vec3> points) {
    ContainsBatch batch = contains(*bodies_[1 - body], points, limits_.alone());
    cost_ += batch.cost;
    late_ = late_ || detail::coverage_of(batch.coverage) == Coverage::cut;
    return std::move(batch.side);
  }

  /// Corners of a triangle on both sides of the other body prove a crossing, if it bounds its own
  /// body at both: there is some of both sides of its surface inside the other body, and some
  /// outside.
  void look_at_corners(std::size_t body, std::span<const TriangleId> ids) {
    if (regions_.all() || late_) {
      return;
    }
    std::vector<Vec3> corners;
    corners.reserve(3 * ids.size());
    for (const TriangleId id : ids) {
      const Triangle t = search_.moved(body, id);
      corners.insert(corners.end(), {t.a, t.b, t.c});
    }
    const std::vector<Side> sides = sides_of(body, corners);
    for (std::size_t i = 0; i < ids.size() && !regions_.all(); ++i) {
      const auto of_triangle = std::span(sides).subspan(3 * i, 3);
      const auto any = [&](Side side) {
        return std::find(of_triangle.begin(), of_triangle.end(), side) != of_triangle.end();
      };
      if (any(Side::inside) && any(Side::outside) && search_.stands_alone(body, ids[i])) {
        regions_.add_sides(body, true);
        regions_.add_sides(body, false);
      }
    }
  }

  /// Four points about the middle of where two triangles cross. A point off both surfaces has
  /// others all around it that are where it is, so it is of a region, whatever made one look at it.
  void look_at_quarters(const TrianglePair& pair) {
    if (regions_.all() || late_) {
      return;
    }
    const auto points = quarter_points(search_.moved(0, pair.a), search_.moved(1, pair.b));
    if (!points) {
      return;
    }
    const std::vector<Side> in_a = sides_of(1, *points);
    const std::vector<Side> in_b = sides_of(0, *points);
    const auto decided = [](Side side) { return side == Side::inside || side == Side::outside; };
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (decided(in_a[i]) && decided(in_b[i])) {
        regions_.add(in_a[i] == Side::inside, in_b[i] == Side::inside);
      }
    }
  }

  /// The corners of a few triangles in contact, from all over the contact.
  void look_at_some_corners(std::size_t body) {
    const std::vector<TriangleId>& all = in_contact_[body];
    const std::size_t count = std::min(all.size(), kFewTriangles);
    std::vector<TriangleId> some;
    for (std::size_t i = 0; i < count; ++i) {
      some.push_back(all[i * all.size() / count]);
    }
    look_at_corners(body, some);
  }

  /// The cells of all triangles that overlap one of the other body.
  void look_at_contacts() {
    const Overlap all = overlap(bodies_[0]->body(), bodies_[1]->body(), {}, limits_);
    cost_ += all.cost;
    late_ = late_ || all.coverage == Coverage::cut;
    for (const auto& [i, j] : all.pairs) {
      in_contact_[0].push_back(i);
      in_contact_[1].push_back(j);
    }
    for (std::vector<TriangleId>& ids : in_contact_) {
      std::sort(ids.begin(), ids.end());
      ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    }
    look_at_some_corners(0);
    look_at_some_corners(1);
    for (std::size_t body = 0; body < 2; ++body) {
      for (const TriangleId id : in_contact_[body]) {
        if (stop()) {
          return;
        }
        search_.look_at(body, id, regions_);
      }
    }
  }

  /// What overlaps nothing. Beside a triangle that was looked at, that has a cell for each of its
  /// corners off the other body, in which its own body is odd, nothing new can be: so it suffices
  /// to look at connected parts without such triangles, unless some were idle.
  void look_at_rest() {
    std::array<LooseTriangles, 2> loose;
    for (std::size_t body = 0; body < 2; ++body) {
      loose[body] = loose_triangles(body);
      if (late_) {
        return;
      }
      look_at_loose(body, Side::inside, loose[body]);
    }
    // Without shared interior it does not matter what else there is.
    for (std::size_t body = 0; body < 2 && regions_.both && !late_; ++body) {
      look_at_loose(body, Side::outside, loose[body]);
    }
  }

  LooseTriangles loose_triangles(std::size_t body) {
    const ClosedSurface& surface = surface_of(*bodies_[body]);
    LooseTriangles loose;
    if (search_.met_idle(body)) {
      const auto count = static_cast<TriangleId>(mesh_of(body).triangles.size());
      for (TriangleId id = 0; id < count; ++id) {
        if (!in_contact(body, id)) {
          loose.ids.push_back(id);
        }
      }
    } else {
      std::vector<bool> touches(surface.first.size(), false);
      for (const TriangleId id : in_contact_[body]) {
        touches[surface.part(id)] = true;
      }
      for (std::size_t part = 0; part < touches.size(); ++part) {
        if (!touches[part]) {
          loose.ids.push_back(surface.first[part]);
        }
      }
    }
    std::vector<Vec3> points;
    points.reserve(loose.ids.size());
    for (const TriangleId id : loose.ids) {
      points.push_back(search_.moved(body, id).a);
    }
    loose.sides = sides_of(body, points);
    return loose;
  }

  /// Finds out whether a body has a boundary on that side of the other, if that is news.
  void look_at_loose(std::size_t body, Side side, const LooseTriangles& loose) {
    SolidRegions more = regions_;
    more.add_sides(body, side == Side::inside);
    if (more == regions_) {
      return;
    }
    for (std::size_t i = 0; i < loose.ids.size(); ++i) {
      if (loose.sides[i] == side && bounds_anything(body, loose.ids[i])) {
        regions_ = more;
        return;
      }
    }
    // The first triangles of these parts are idle; others may not be.
    const ClosedSurface& surface = surface_of(*bodies_[body]);
    const auto count = static_cast<TriangleId>(mesh_of(body).triangles.size());
    std::vector<bool> wanted(surface.first.size(), false);
    bool any = false;
    for (std::size_t i = 0; i < loose.ids.size() && !search_.met_idle(body); ++i) {
      wanted[surface.part(loose.ids[i])] = loose.sides[i] == side;
      any = any || loose.sides[i] == side;
    }
    for (TriangleId id = 0; any && id < count; ++id) {
      if (wanted[surface.part(id)] && bounds_anything(body, id)) {
        regions_ = more;
        return;
      }
    }
  }

  bool bounds_anything(std::size_t body, TriangleId id) {
    return !stop() && search_.bounds_anything(body, id);
  }

  [[nodiscard]] bool in_contact(std::size_t body, TriangleId id) const {
    return std::binary_search(in_contact_[body].begin(), in_contact_[body].end(), id);
  }

  [[nodiscard]] const MeshView& mesh_of(std::size_t body) const {
    return bodies_[body]->body().shape.mesh();
  }

  std::array<const ClosedBody*, 2> bodies_;
  RegionSearch search_;
  const Limits& limits_;
  Limit limit_;
  SolidRegions regions_;
  std::array<std::vector<TriangleId>, 2> in_contact_;  // sorted
  Cost cost_;
  bool late_ = false;
};

}  // namespace

Solid solid_relation(const ClosedBody& a, const ClosedBody& b, const FirstContact& contact,
                     const Limits& limits) {
  Solid answer{.surfaces_meet = contact.pair.has_value(), .cost = contact.cost};
  bool decided = !contact.cut;
  if (decided) {
    SolidSearch search(a, b, limits);
    decided = search.run(contact.pair) || search.regions().all();
    answer.relation = search.regions().relation(answer.surfaces_meet);
    answer.cost += search.cost();
  }
  if (!decided) {
    answer.relation = soms::Relation::undecided;
    answer.why = Undecided::deadline;
    answer.coverage = Coverage::cut;
  }
  return answer;
}

}  // namespace soms::detail
