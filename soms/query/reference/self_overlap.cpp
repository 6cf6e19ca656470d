#include "soms/query/reference/self_overlap.h"

#include "soms/base/arithmetic.h"
#include "soms/query/detail/self/neighbors.h"
#include "soms/query/reference/overlap.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace soms::reference {

namespace {

using Place = std::tuple<double, double, double>;

/// For each vertex the first one that stands for it.
std::vector<std::uint32_t> names_of(const MeshView& mesh, CommonCorners by) {
  std::vector<std::uint32_t> names(mesh.vertices.size());
  std::map<Place, std::uint32_t> first;  // where -0 and 0 are one
  for (std::uint32_t v = 0; v < names.size(); ++v) {
    const Vec3& p = mesh.vertices[v];
    names[v] = by == CommonCorners::index ? v : first.try_emplace({p.x, p.y, p.z}, v).first->second;
  }
  return names;
}

}  // namespace

SelfOverlap self_overlap(const MeshView& mesh, CommonCorners by, const Limits& limits) {
  const PlainArithmetic plain;
  const std::vector<std::uint32_t> names = names_of(mesh, by);
  const auto corners_of = [&](TriangleId id) {
    soms::detail::CornerNames corners = mesh.triangles[id];
    for (std::uint32_t& corner : corners) {
      corner = names[corner];
    }
    return corners;
  };
  const Overlap touching = overlap(mesh, {}, mesh, {}, limits);
  SelfOverlap answer;
  answer.coverage = touching.coverage;
  for (const TrianglePair& pair : touching.pairs) {
    if (pair.a >= pair.b) {
      continue;
    }
    const soms::detail::CornerNames a = corners_of(pair.a);
    const soms::detail::CornerNames b = corners_of(pair.b);
    const bool apart = std::none_of(a.begin(), a.end(), [&](std::uint32_t corner) {
      return std::find(b.begin(), b.end(), corner) != b.end();
    });
    const soms::detail::Neighbors neighbors(a, b);
    if (apart || (!neighbors.duplicate() && neighbors.share_more(mesh.vertices))) {
      answer.pairs.push_back(pair);
    } else if (neighbors.duplicate()) {
      answer.duplicates.push_back(pair);
    }
  }
  answer.any = !answer.pairs.empty();
  return answer;
}

}  // namespace soms::reference
