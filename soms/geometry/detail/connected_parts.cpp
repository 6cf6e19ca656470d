#include "soms/geometry/detail/connected_parts.h"

#include "soms/geometry/detail/joined.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace soms::detail {

namespace {

constexpr std::uint32_t kNoPart = 0xffffffffU;

/// Sets of vertices that grow together.
class VertexSets {
 public:
  explicit VertexSets(std::size_t size) : above_(size) {
    std::iota(above_.begin(), above_.end(), 0U);
  }

  [[nodiscard]] std::uint32_t find(std::uint32_t v) {
    while (above_[v] != v) {
      above_[v] = above_[above_[v]];
      v = above_[v];
    }
    return v;
  }

  void unite(std::uint32_t v, std::uint32_t w) {
    v = find(v);
    w = find(w);
    // The lesser one stays, and paths are halved: logarithmic on average, whatever the order.
    above_[std::max(v, w)] = std::min(v, w);
  }

 private:
  std::vector<std::uint32_t> above_;
};

}  // namespace

std::uint64_t connected_parts_work(const Mesh& mesh) {
  return 2 * std::uint64_t{mesh.triangles.size()} + mesh.vertices.size();
}

ConnectedParts connected_parts(const Mesh& mesh, const std::vector<std::uint32_t>& joined,
                               Work& work) {
  VertexSets sets(mesh.vertices.size());
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
