#include "soms/clash/reference/clash.h"

#include "soms/base/arithmetic.h"
#include "soms/clash/detail/clash_kind.h"
#include "soms/clash/detail/open_parts.h"
#include "soms/query/detail/moved_triangle.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"
#include "soms/query/reference/solid.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace soms::reference {

namespace {

Box box_of(const Body& body) {
  const PlainArithmetic plain;
  Box box;
  const MeshView& mesh = body.shape.mesh();
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t v : corners) {
      box.grow(body.pose.apply(mesh.vertices[v]));
    }
  }
  return box;
}

/// Triangles of a body that hang together by corners in one place, found by comparing them all.
struct Piece {
  Vec3 corner;
  Box box;
};

std::vector<Piece> pieces_of(const Body& body) {
  const PlainArithmetic plain;
  const MeshView& mesh = body.shape.mesh();
  const auto corners = [&](std::size_t i) {
    const Triangle t = mesh.triangle(static_cast<TriangleId>(i));
    return std::array{t.a, t.b, t.c};
  };
  const auto touch = [&](std::size_t i, std::size_t j) {
    const auto first = corners(i);
    const auto second = corners(j);
    return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) !=
           first.end();
  };
  std::vector<Piece> pieces;
  std::vector<bool> reached(mesh.triangles.size(), false);
  for (std::size_t start = 0; start < reached.size(); ++start) {
    if (reached[start]) {
      continue;
    }
    Piece piece{.corner = body.pose.apply(corners(start)[0]), .box = {}};
    std::vector<std::size_t> open{start};
    reached[start] = true;
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      for (const Vec3& corner : corners(i)) {
        piece.box.grow(body.pose.apply(corner));
      }
      for (std::size_t j = 0; j < reached.size(); ++j) {
        if (!reached[j] && touch(i, j)) {
          reached[j] = true;
          open.push_back(j);
        }
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

/// An edge of a triangle of one body crosses one of the other; all triangles of both may be in the
/// way.
bool cross_each_other(const Body& a, const Body& b, const std::vector<TrianglePair>& met) {
  const auto all_but = [](const Body& body, TriangleId left_out) {
    return detail::TriangleLoop([&body, left_out](const auto& check) {
      for (std::size_t i = 0; i < body.shape.mesh().triangles.size(); ++i) {
        const auto id = static_cast<TriangleId>(i);
        if (id != left_out && !check(detail::moved_triangle(body, id))) {
          return false;
        }
      }
      return true;
    });
  };
  return std::any_of(met.begin(), met.end(), [&](const TrianglePair& pair) {
    const Triangle s = detail::moved_triangle(a, pair.a);
    const Triangle t = detail::moved_triangle(b, pair.b);
    const detail::TriangleLoop of_a = all_but(a, pair.a);
    const detail::TriangleLoop of_b = all_but(b, pair.b);
    return detail::edge_crosses(s, t, of_a, of_b) || detail::edge_crosses(t, s, of_b, of_a);
  });
}

/// How pieces that do not meet the surface of a closed body lie to it.
Relation by_pieces(const std::vector<Piece>& pieces, const Body& closed, Relation all_inside) {
  const auto inside =
      static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
        return contains_by_brute_force(closed, piece.corner) == Side::inside;
      }));
  return inside == 0 ? Relation::clear : inside == pieces.size() ? all_inside : Relation::crossing;
}

bool one_fits_into(const std::vector<Piece>& pieces, const Box& box) {
  return std::any_of(pieces.begin(), pieces.end(),
                     [&](const Piece& piece) { return box.contains(piece.box); });
}

/// Edges of an odd number of triangles, by their moved ends, counted one by one.
std::vector<std::pair<Vec3, Vec3>> odd_edges_of(const Body& body) {
  const PlainArithmetic plain;
  const MeshView& mesh = body.shape.mesh();
  using Ends = std::array<std::array<double, 3>, 2>;
  std::map<Ends, std::size_t> uses;
  const auto place = [](const Vec3& v) { return std::array{v.x + 0.0, v.y + 0.0, v.z + 0.0}; };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(static_cast<TriangleId>(i));
    const std::array<Vec3, 3> corners{t.a, t.b, t.c};
    for (std::size_t k = 0; k < 3; ++k) {
      Ends ends{place(corners[k]), place(corners[(k + 1) % 3])};
      std::sort(ends.begin(), ends.end());
      ++uses[ends];
    }
  }
  std::vector<std::pair<Vec3, Vec3>> odd;
  for (const auto& [ends, count] : uses) {
    if (count % 2 == 1 && ends[0] != ends[1]) {
      const auto moved = [&](const std::array<double, 3>& v) {
        return body.pose.apply({v[0], v[1], v[2]});
      };
      odd.emplace_back(moved(ends[0]), moved(ends[1]));
    }
  }
  return odd;
}

/// A triangle from each odd edge to the middle of the box around those that share ends with it.
Mesh caps_of(const Body& open) {
  std::vector<std::pair<Vec3, Vec3>> left = odd_edges_of(open);
  Mesh caps;
  while (!left.empty()) {
    std::vector<std::pair<Vec3, Vec3>> group{left.back()};
    left.pop_back();
    Box box;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const auto [from, to] = group[k];
      box.grow(from);
      box.grow(to);
      const auto joins = [from = from, to = to](const auto& edge) {
        return edge.first == from || edge.first == to || edge.second == from || edge.second == to;
      };
      std::copy_if(left.begin(), left.end(), std::back_inserter(group), joins);
      std::erase_if(left, joins);
    }
    for (const auto& [from, to] : group) {
      const auto at = static_cast<std::uint32_t>(caps.vertices.size());
      caps.vertices.insert(caps.vertices.end(), {from, to, box.center()});
      caps.triangles.push_back({at, at + 1, at + 2});
    }
  }
  return caps;
}

}  // namespace

Mesh caps_by_brute_force(const Body& open) {
  return caps_of(open);
}

namespace {

bool may_hold(const std::vector<Piece>& pieces, const Body& inner, const Body& open) {
  return one_fits_into(pieces, box_of(open)) ||
         overlap(inner.shape.mesh(), inner.pose, caps_of(open), {}, {}).any;
}

/// The relation as far as it is known where one of the parts is open, or both are.
Relation relation_of_open(const PartBody& a, const PartBody& b,
                          const std::vector<TrianglePair>& met) {
  if (!met.empty()) {
    return cross_each_other(a.body, b.body, met) ? Relation::crossing : Relation::undecided;
  }
  const std::vector<Piece> pieces_a = pieces_of(a.body);
  const std::vector<Piece> pieces_b = pieces_of(b.body);
  if (a.closed) {
    if (const Relation found = by_pieces(pieces_b, a.body, Relation::b_in_a);
        found != Relation::clear) {
      return found == Relation::b_in_a && one_fits_into(pieces_a, box_of(b.body))
                 ? Relation::undecided
                 : found;
    }
  }
  if (b.closed) {
    if (const Relation found = by_pieces(pieces_a, b.body, Relation::a_in_b);
        found != Relation::clear) {
      return found == Relation::a_in_b && one_fits_into(pieces_b, box_of(a.body))
                 ? Relation::undecided
                 : found;
    }
  }
  const bool doubtful = (!a.closed && may_hold(pieces_b, b.body, a.body)) ||
                        (!b.closed && may_hold(pieces_a, a.body, b.body));
  return doubtful ? Relation::undecided : Relation::clear;
}

/// The clash of two parts, whatever they are together with others.
std::optional<Clash> clash_of_parts(const PartBody& a, const PartBody& b,
                                    std::optional<double> within, const Limits& limits) {
  Clash clash;
  const Overlap met = overlap(a.body.shape.mesh(), a.body.pose, b.body.shape.mesh(), b.body.pose,
                              {.stop = limits.stop});
  clash.triangle_pairs = met.pairs.size();
  clash.relation = a.closed && b.closed
                       ? solid_by_brute_force(a.body, b.body, {.stop = limits.stop}).relation
                       : relation_of_open(a, b, met.pairs);
  clash.kind = detail::kind_of(clash.relation);
  if (clash.relation == Relation::clear &&
      (!within || !within_by_brute_force(a.body, b.body, *within, {.stop = limits.stop}))) {
    return std::nullopt;
  }
  if (clash.kind == ClashKind::undecided) {
    clash.why = Undecided::open;
  }
  if (!met.any) {
    clash.gap = distance_by_brute_force(a.body, b.body, {.stop = limits.stop}).distance;
  }
  return clash;
}

/// The open group of which a part is the first, or the part where it is of none; nothing for the
/// other parts of a group.
const PartBody* led_by(const PartBody& part) {
  const PartBody* const group = part.together.body.get();
  return group == nullptr ? &part : group->part == part.part ? group : nullptr;
}

/// Whether one of two bodies, an open group, may hold something of the other that no part of it
/// touches or may hold.
bool group_may_hold(const PartBody& a, const PartBody& b) {
  const PartBody* const whole_a = led_by(a);
  const PartBody* const whole_b = led_by(b);
  if (whole_a == nullptr || whole_b == nullptr || whole_a == whole_b ||
      (whole_a == &a && whole_b == &b)) {
    return false;
  }
  if (overlap(whole_a->body.shape.mesh(), whole_a->body.pose, whole_b->body.shape.mesh(),
              whole_b->body.pose, {})
          .any) {
    return false;
  }
  const auto none_in = [](const PartBody& closed, const PartBody& other) {
    return !closed.closed ||
           by_pieces(pieces_of(other.body), closed.body, Relation::b_in_a) == Relation::clear;
  };
  const auto holds = [](const PartBody& group, const PartBody& other) {
    return may_hold(pieces_of(other.body), other.body, group.body);
  };
  return none_in(*whole_a, *whole_b) && none_in(*whole_b, *whole_a) &&
         ((whole_a != &a && holds(*whole_a, *whole_b)) ||
          (whole_b != &b && holds(*whole_b, *whole_a)));
}

}  // namespace

std::optional<Clash> clash_by_brute_force(const PartBody& a, const PartBody& b,
                                          std::optional<double> within, const Limits& limits) {
  std::optional<Clash> clash = clash_of_parts(a, b, within, limits);
  if ((clash && clash->kind != ClashKind::near) || !group_may_hold(a, b)) {
    return clash;
  }
  return Clash{
      .why = Undecided::open,
      .gap = distance_by_brute_force(led_by(a)->body, led_by(b)->body, {.stop = limits.stop})
                 .distance};
}

std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> a, std::span<const PartBody> b,
                                          std::optional<double> within, const Limits& limits) {
  std::vector<Clash> found;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (std::optional<Clash> clash = clash_by_brute_force(a[i], b[j], within, limits)) {
        clash->a = static_cast<std::uint32_t>(i);
        clash->b = static_cast<std::uint32_t>(j);
        found.push_back(*clash);
      }
    }
  }
  return found;
}

std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> parts,
                                          std::optional<double> within, const Limits& limits) {
  std::vector<Clash> found;
  for (Clash& clash : clashes_by_brute_force(parts, parts, within, limits)) {
    if (clash.a < clash.b) {
      found.push_back(clash);
    }
  }
  return found;
}

}  // namespace soms::reference
