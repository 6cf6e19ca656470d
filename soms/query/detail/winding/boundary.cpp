#include "soms/query/detail/winding/boundary.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace soms::detail {

void add_edges(const std::array<std::uint32_t, 3>& corners, std::int32_t times,
               std::vector<BoundaryEdge>& edges) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t from = corners[k];
    const std::uint32_t to = corners[(k + 1) % 3];
    if (from != to) {
      edges.push_back({from, to, times});
    }
  }
}

void cancel(std::vector<BoundaryEdge>& edges) {
  for (BoundaryEdge& edge : edges) {
    if (edge.from > edge.to) {
      edge = {edge.to, edge.from, -edge.times};
    }
  }
  const auto ends = [](const BoundaryEdge& e) { return std::pair(e.from, e.to); };
  std::sort(edges.begin(), edges.end(),
            [&](const BoundaryEdge& a, const BoundaryEdge& b) { return ends(a) < ends(b); });
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < edges.size();) {
    BoundaryEdge edge = edges[begin];
    std::size_t next = begin + 1;
    for (; next < edges.size() && ends(edges[next]) == ends(edge); ++next) {
      edge.times += edges[next].times;
    }
    if (edge.times < 0) {
      edge = {edge.to, edge.from, -edge.times};
    }
    if (edge.times != 0) {
      edges[kept++] = edge;
    }
    begin = next;
  }
  edges.resize(kept);
}

}  // namespace soms::detail
