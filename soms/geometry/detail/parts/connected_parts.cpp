#include "soms/geometry/detail/parts/connected_parts.h"

#include "soms/geometry/detail/parts/disjoint_sets.h"
#include "soms/geometry/detail/parts/joined.h"

#include <cstddef>

namespace soms::detail {

namespace {

constexpr std::uint32_t kNoPart = 0xffffffffU;

}  // namespace

std::uint64_t connected_parts_work(const MeshView& mesh) {
  return 2 * std::uint64_t{mesh.triangles.size()} + mesh.vertices.size();
}

ConnectedParts connected_parts(const MeshView& mesh, const std::vector<std::uint32_t>& joined,
                               Work& work) {
  DisjointSets sets(mesh.vertices.size());
  work.run(mesh.triangles.size(), [&](std::size_t i) {
    const auto& t = mesh.triangles[i];
    sets.unite(joined[t[0]], joined[t[1]]);
    sets.unite(joined[t[0]], joined[t[2]]);
  });
  ConnectedParts parts;
  std::vector<std::uint32_t> of_set(mesh.vertices.size(), kNoPart);
  work.run(mesh.triangles.size(), [&](std::size_t i) {
    std::uint32_t& part = of_set[sets.find(joined[mesh.triangles[i][0]])];
    if (part == kNoPart) {
      part = static_cast<std::uint32_t>(parts.first.size());
      parts.first.push_back(static_cast<TriangleId>(i));
    }
  });
  parts.part_of.assign(mesh.vertices.size(), kNoPart);
  work.run(mesh.vertices.size(), [&](std::size_t v) {
    if (joined[v] != kUnused) {
      parts.part_of[v] = of_set[sets.find(joined[v])];
    }
  });
  return parts;
}

}  // namespace soms::detail
