#include "soms/clash/part_bodies.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/detail/closed_surface.h"
#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace soms {

namespace {

/// Most odd edges that a part names.
constexpr std::size_t kEdgePlaces = 5;

/// Parts are dealt out to threads in pieces of so many: some have two triangles, some a million.
constexpr std::size_t kPartsOfAChunk = 16;

/// Some triangles of a mesh, with the vertices that they use in the order of the mesh.
Mesh mesh_of(const Mesh& mesh, const std::vector<TriangleId>& triangles) {
  Mesh part;
  part.source = mesh.source;
  std::vector<std::uint32_t> used;
  used.reserve(3 * triangles.size());
  for (const TriangleId i : triangles) {
    used.insert(used.end(), mesh.triangles[i].begin(), mesh.triangles[i].end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  part.vertices.reserve(used.size());
  for (const std::uint32_t vertex : used) {
    part.vertices.push_back(mesh.vertices[vertex]);
  }
  part.triangles.reserve(triangles.size());
  for (const TriangleId i : triangles) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<std::uint32_t>(
          std::lower_bound(used.begin(), used.end(), mesh.triangles[i][k]) - used.begin());
    }
    part.triangles.push_back(corners);
  }
  return part;
}

/// The triangles of each part, by the order of Mesh::parts.
std::vector<PartBody> divided(const Mesh& mesh) {
  const PartsOf part_of(mesh);
  // One place more, for the triangles of no part.
  std::vector<std::vector<TriangleId>> triangles(mesh.parts.size() + 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    triangles[std::min<std::size_t>(part_of(id), mesh.parts.size())].push_back(id);
  }
  std::vector<PartBody> parts;
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    if (!triangles[p].empty()) {
      const auto part = static_cast<std::uint32_t>(p);
      parts.push_back({.part = p < mesh.parts.size() ? part : Part::kNoParent,
                       .triangles = std::move(triangles[p])});
    }
  }
  return parts;
}

std::vector<PartComponent> components_of(const Body& body, const detail::ClosedSurface& surface) {
  std::vector<PartComponent> components(surface.first.size());
  for (std::size_t k = 0; k < components.size(); ++k) {
    components[k].corner = detail::moved_triangle(body, surface.first[k]).a;
  }
  for (std::size_t i = 0; i < body.shape.mesh().triangles.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    components[surface.part(id)].box.grow(bounds(detail::moved_triangle(body, id)));
  }
  return components;
}

void give_body(const Mesh& mesh, const Pose& pose, PartBody& part) {
  part.body = Body(mesh_of(mesh, part.triangles), pose);
  if (part.part != Part::kNoParent) {
    part.body.name = mesh.parts[part.part].name;
  }
  const Mesh& own = part.body.shape.mesh();
  const auto surface =
      std::make_shared<const detail::ClosedSurface>(detail::closed_surface(own, Parallel()));
  part.components = components_of(part.body, *surface);
  part.odd_edges = surface->odd_count();
  if (surface->is_closed(own, pose)) {
    part.closed.emplace(detail::closed_body(part.body, surface));
  } else {
    part.caps = Body(surface->caps(part.body));
    part.places = closedness(own, {.pose = pose, .places = kEdgePlaces}).places;
  }
}

}  // namespace

Box PartBody::box() const {
  Box box;
  for (const PartComponent& component : components) {
    box.grow(component.box);
  }
  return box;
}

std::vector<PartBody> part_bodies(const Mesh& mesh, const Pose& pose, const Parallel& parallel) {
  std::vector<PartBody> parts = divided(mesh);
  for_each_chunk(parts.size(), kPartsOfAChunk, parallel, [&](std::size_t begin, std::size_t end) {
    const PlainArithmetic plain;
    for (std::size_t k = begin; k < end; ++k) {
      give_body(mesh, pose, parts[k]);
    }
  });
  return parts;
}

}  // namespace soms
