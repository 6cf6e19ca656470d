#include "soms/query/detail/closed_surface.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/parts/connected_parts.h"
#include "soms/geometry/detail/parts/joined.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace soms::detail {

std::uint64_t ClosedSurface::odd_count() const {
  return static_cast<std::uint64_t>(
      std::count_if(odd.begin(), odd.end(), [](const OddEdge& edge) { return edge.among_all; }));
}

Mesh ClosedSurface::caps(const Body& body) const {
  const PlainArithmetic plain;
  // Each vertex leads to another of its opening, the first one to itself.
  std::unordered_map<std::uint32_t, std::uint32_t> leads;
  const auto first_of = [&](std::uint32_t vertex) {
    std::uint32_t at = leads.try_emplace(vertex, vertex).first->second;
    while (leads.at(at) != at) {
      at = leads.at(at);
    }
    leads[vertex] = at;
    return at;
  };
  const auto counts = [](const OddEdge& edge) {
    return edge.among_all && edge.ends[0] != edge.ends[1];
  };
  for (const OddEdge& edge : odd) {
    if (counts(edge)) {
      const std::uint32_t from = first_of(edge.ends[0]);
      leads[first_of(edge.ends[1])] = from;
    }
  }
  const auto place = [&](std::uint32_t vertex) {
    return body.pose.apply(body.shape.mesh().vertices[vertex]);
  };
  std::map<std::uint32_t, Box> boxes;
  for (const OddEdge& edge : odd) {
    if (counts(edge)) {
      Box& box = boxes[first_of(edge.ends[0])];
      box.grow(place(edge.ends[0]));
      box.grow(place(edge.ends[1]));
    }
  }
  Mesh mesh;
  for (const OddEdge& edge : odd) {
    if (counts(edge)) {
      const auto at = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), {place(edge.ends[0]), place(edge.ends[1]),
                                                 boxes.at(first_of(edge.ends[0])).center()});
      mesh.triangles.push_back({at, at + 1, at + 2});
    }
  }
  return mesh;
}

bool ClosedSurface::is_closed(const MeshView& mesh, const Pose& pose) const {
  return cover_evenly(mesh, odd, pose);
}

ClosedSurface closed_surface(const MeshView& mesh, const Limits& limits) {
  Work work(limits, joining_work(mesh) + mesh.triangles.size() + odd_edges_work(mesh) +
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
