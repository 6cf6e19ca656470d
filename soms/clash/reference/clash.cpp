#include "soms/clash/reference/clash.h"

#include "soms/base/arithmetic.h"
#include "soms/query/reference/distance.h"
#include "soms/query/reference/overlap.h"
#include "soms/query/reference/solid.h"

#include <cstddef>

namespace soms::reference {

namespace {

Box box_of(const Body& body) {
  const PlainArithmetic plain;
  Box box;
  const Mesh& mesh = body.shape.mesh();
  for (const auto& corners : mesh.triangles) {
    for (const std::uint32_t v : corners) {
      box.grow(body.pose.apply(mesh.vertices[v]));
    }
  }
  return box;
}

ClashKind kind_by_relation(Relation relation) {
  if (relation == Relation::a_in_b || relation == Relation::b_in_a) {
    return ClashKind::inside;
  }
  return relation == Relation::crossing ? ClashKind::crossing
         : relation == Relation::same   ? ClashKind::same
                                        : ClashKind::touching;
}

}  // namespace

std::optional<Clash> clash_by_brute_force(const PartBody& a, const PartBody& b,
                                          std::optional<double> within, const Parallel& parallel) {
  Clash clash;
  const Overlap met = overlap(a.body.shape.mesh(), a.body.pose, b.body.shape.mesh(), b.body.pose,
                              {.stop = parallel.stop});
  clash.triangle_pairs = met.pairs.size();
  const bool closed = a.closed && b.closed;
  if (closed) {
    clash.relation = solid_by_brute_force(a.body, b.body, {.stop = parallel.stop}).relation;
  }
  const bool clear = closed ? clash.relation == Relation::clear
                            : !met.any && !overlaps(box_of(a.body), box_of(b.body));
  if (clear) {
    if (!within || !within_by_brute_force(a.body, b.body, *within, {.stop = parallel.stop})) {
      return std::nullopt;
    }
    clash.kind = ClashKind::near;
    clash.relation = Relation::clear;
  } else if (closed) {
    clash.kind = kind_by_relation(clash.relation);
  } else {
    clash.why = Undecided::open;
  }
  if (!met.any) {
    clash.gap = distance_by_brute_force(a.body, b.body, {.stop = parallel.stop}).distance;
  }
  return clash;
}

std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> a, std::span<const PartBody> b,
                                          std::optional<double> within, const Parallel& parallel) {
  std::vector<Clash> found;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (std::optional<Clash> clash = clash_by_brute_force(a[i], b[j], within, parallel)) {
        clash->a = static_cast<std::uint32_t>(i);
        clash->b = static_cast<std::uint32_t>(j);
        found.push_back(*clash);
      }
    }
  }
  return found;
}

std::vector<Clash> clashes_by_brute_force(std::span<const PartBody> parts,
                                          std::optional<double> within, const Parallel& parallel) {
  std::vector<Clash> found;
  for (Clash& clash : clashes_by_brute_force(parts, parts, within, parallel)) {
    if (clash.a < clash.b) {
      found.push_back(clash);
    }
  }
  return found;
}

}  // namespace soms::reference
