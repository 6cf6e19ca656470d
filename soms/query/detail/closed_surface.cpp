#include "soms/query/detail/closed_surface.h"

#include "soms/geometry/detail/connected_parts.h"
#include "soms/geometry/detail/joined.h"

#include <algorithm>
#include <utility>

namespace soms::detail {

std::uint64_t ClosedSurface::odd_count() const {
  return static_cast<std::uint64_t>(
      std::count_if(odd.begin(), odd.end(), [](const OddEdge& edge) { return edge.among_all; }));
}

bool ClosedSurface::is_closed(const Mesh& mesh, const Pose& pose) const {
  return cover_evenly(mesh, odd, pose);
}

ClosedSurface closed_surface(const Mesh& mesh, const Parallel& parallel) {
  Work work(parallel, joining_work(mesh) + mesh.triangles.size() + odd_edges_work(mesh) +
                          connected_parts_work(mesh) + 1);
  const std::vector<std::uint32_t> joined = joined_by_position(mesh, work);
  ClosedSurface surface;
  surface.odd = odd_edges(mesh, joined, degenerate_triangles(mesh, work), work);
  ConnectedParts parts = connected_parts(mesh, joined, work);
  surface.first = std::move(parts.first);
  if (surface.first.size() > 1) {
    surface.part_of.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
      surface.part_of.push_back(parts.part_of[t[0]]);
    }
  }
  return surface;
}

}  // namespace soms::detail
