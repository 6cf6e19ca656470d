#include "soms/clash/part_bodies.h"

#include "soms/base/arithmetic.h"
#include "soms/base/parallel.h"
#include "soms/geometry/bodies_of.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/detail/parts/part_groups.h"
#include "soms/geometry/parts_of.h"
#include "soms/query/detail/closed_surface.h"
#include "soms/query/detail/moved_triangle.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace soms {

namespace {

/// Most odd edges that a part names.
constexpr std::size_t kEdgePlaces = 5;

/// Parts are dealt out to threads in pieces of so many: some have two triangles, some a million.
constexpr std::size_t kPartsOfAChunk = 16;

/// Some triangles of a mesh, with the vertices that they use in the order of the mesh.
Mesh mesh_of(const MeshView& mesh, const std::vector<TriangleId>& triangles) {
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

/// A body while it is made.
struct Piece {
  PartBody part;
  Mesh mesh = {};  ///< its own triangles
  std::shared_ptr<const detail::ClosedSurface> surface = nullptr;
  bool may_close = true;  ///< false for a group that may be closed in several ways

  /// Gives it the mesh and the surface of its triangles.
  void cut_out_of(const MeshView& whole) {
    mesh = mesh_of(whole, part.triangles);
    surface = std::make_shared<const detail::ClosedSurface>(detail::closed_surface(mesh, Limits()));
  }
};

/// The triangles of each part, by the order of Mesh::parts.
std::vector<Piece> divided(const MeshView& mesh) {
  const PartsOf part_of(mesh);
  // One place more, for the triangles of no part.
  std::vector<std::vector<TriangleId>> triangles(mesh.parts.size() + 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto id = static_cast<TriangleId>(i);
    triangles[std::min<std::size_t>(part_of(id), mesh.parts.size())].push_back(id);
  }
  std::vector<Piece> pieces;
  for (std::size_t p = 0; p < triangles.size(); ++p) {
    if (!triangles[p].empty()) {
      const auto part = static_cast<std::uint32_t>(p);
      pieces.push_back({.part = {.part = p < mesh.parts.size() ? part : Part::kNoParent,
                                 .triangles = std::move(triangles[p])}});
    }
  }
  return pieces;
}

/// The odd edges of a piece where it is not moved; empty where it is closed.
std::vector<detail::Segment> open_edges(const Piece& piece) {
  std::vector<detail::Segment> edges;
  if (!piece.surface->is_closed(piece.mesh, Pose{})) {
    for (const detail::OddEdge& edge : piece.surface->odd) {
      if (edge.among_all && edge.ends[0] != edge.ends[1]) {
        edges.push_back({piece.mesh.vertices[edge.ends[0]], piece.mesh.vertices[edge.ends[1]]});
      }
    }
  }
  return edges;
}

/// Whether parts close each other: those of a group that is not closed may, in several ways.
bool are_closed(const PartGroup& group, std::span<const detail::OpenPart> open) {
  std::vector<detail::Segment> edges;
  for (const std::uint32_t part : group.parts) {
    const auto at = std::lower_bound(
        open.begin(), open.end(), part,
        [](const detail::OpenPart& known, std::uint32_t number) { return known.part < number; });
    edges.insert(edges.end(), at->edges.begin(), at->edges.end());
  }
  return detail::covers_evenly(edges);
}

/// All triangles of some parts, named by the first. `piece_of` finds the piece of a part.
template <class Find>
Piece united(const PartGroup& group, const Find& piece_of) {
  Piece whole{.part = {.part = group.parts.front()}, .may_close = group.closed};
  whole.part.joined.assign(group.parts.begin() + 1, group.parts.end());
  for (const std::uint32_t part : group.parts) {
    const std::vector<TriangleId>& more = piece_of(part).part.triangles;
    whole.part.triangles.insert(whole.part.triangles.end(), more.begin(), more.end());
  }
  std::sort(whole.part.triangles.begin(), whole.part.triangles.end());
  return whole;
}

/// Puts pieces that are one body together, in the place of the first. Returns what others, which
/// stay as they are, are together.
std::vector<Piece> join(const MeshView& mesh, OpenParts open_parts, std::vector<Piece>& pieces) {
  std::vector<detail::OpenPart> open;
  for (const Piece& piece : pieces) {
    if (std::vector<detail::Segment> edges = open_edges(piece); !edges.empty()) {
      open.push_back({piece.part.part, std::move(edges)});
    }
  }
  if (open.size() < 2) {
    return {};
  }
  const auto piece_of = [&](std::uint32_t part) -> Piece& {
    return *std::lower_bound(
        pieces.begin(), pieces.end(), part,
        [](const Piece& piece, std::uint32_t number) { return piece.part.part < number; });
  };
  std::vector<Piece> unions;
  std::vector<std::uint32_t> gone;
  for (const PartGroup& group : detail::groups_of_open(mesh, open)) {
    if (group.parts.size() < 2) {
      continue;
    }
    Piece whole = united(group, piece_of);
    if (!group.closed && open_parts == OpenParts::alone && !are_closed(group, open)) {
      unions.push_back(std::move(whole));
      continue;
    }
    gone.insert(gone.end(), group.parts.begin() + 1, group.parts.end());
    piece_of(group.parts.front()) = std::move(whole);
  }
  std::sort(gone.begin(), gone.end());
  std::erase_if(pieces, [&](const Piece& piece) {
    return std::binary_search(gone.begin(), gone.end(), piece.part.part);
  });
  return unions;
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

PartBody finished(const MeshView& mesh, const Pose& pose, Piece piece) {
  if (!piece.surface) {
    piece.cut_out_of(mesh);
  }
  PartBody part = std::move(piece.part);
  part.body = Body(std::move(piece.mesh), pose);
  if (part.part != Part::kNoParent) {
    part.body.name = mesh.parts[part.part].name;
  }
  const MeshView& own = part.body.shape.mesh();
  part.components = components_of(part.body, *piece.surface);
  part.odd_edges = piece.surface->odd_count();
  if (piece.may_close && piece.surface->is_closed(own, pose)) {
    part.closed.emplace(detail::closed_body(part.body, piece.surface));
  } else {
    part.caps = Body(piece.surface->caps(part.body));
    part.places = closedness(own, {.pose = pose, .places = kEdgePlaces}).places;
  }
  return part;
}

/// Gives each part of an open group what all of them are together.
void give_unions(std::vector<PartBody> unions, std::vector<PartBody>& parts) {
  for (PartBody& one : unions) {
    const auto body = std::make_shared<const PartBody>(std::move(one));
    const auto give = [&](std::uint32_t number) {
      const auto at = std::lower_bound(
          parts.begin(), parts.end(), number,
          [](const PartBody& part, std::uint32_t wanted) { return part.part < wanted; });
      at->together.body = body;
    };
    give(body->part);
    std::for_each(body->joined.begin(), body->joined.end(), give);
  }
}

}  // namespace

bool OpenUnion::operator==(const OpenUnion& other) const {
  return body == other.body || (body && other.body && body->part == other.body->part &&
                                body->triangles.size() == other.body->triangles.size());
}

Box PartBody::box() const {
  Box box;
  for (const PartComponent& component : components) {
    box.grow(component.box);
  }
  return box;
}

std::vector<PartBody> part_bodies(const MeshView& mesh, const Pose& pose, const Limits& limits,
                                  OpenParts open) {
  std::vector<Piece> pieces = divided(mesh);
  const Limits silent = limits.silent();
  for_each_chunk(pieces.size(), kPartsOfAChunk, silent, [&](std::size_t begin, std::size_t end) {
    const PlainArithmetic plain;
    for (std::size_t k = begin; k < end; ++k) {
      pieces[k].cut_out_of(mesh);
    }
  });
  std::vector<Piece> unions = join(mesh, open, pieces);
  const auto finish = [&](std::vector<Piece>& from, const Limits& how) {
    std::vector<PartBody> bodies(from.size());
    for_each_chunk(bodies.size(), kPartsOfAChunk, how, [&](std::size_t begin, std::size_t end) {
      const PlainArithmetic plain;
      for (std::size_t k = begin; k < end; ++k) {
        bodies[k] = finished(mesh, pose, std::move(from[k]));
      }
    });
    return bodies;
  };
  std::vector<PartBody> parts = finish(pieces, limits);
  give_unions(finish(unions, silent), parts);
  return parts;
}

}  // namespace soms
