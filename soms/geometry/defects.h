/// \file
/// What is wrong, or merely noteworthy, about a mesh: counted and named, never repaired.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {

/// How the proper triangles of a surface (those with area) meet along their edges.
struct EdgeCounts {
  std::uint64_t open = 0;          ///< edges of exactly one proper triangle
  std::uint64_t non_manifold = 0;  ///< edges of more than two proper triangles
  std::uint64_t flipped = 0;       ///< edges that two triangles, and no more, use in one direction
  bool none = false;               ///< no triangle is proper: there is no edge, nor a surface

  [[nodiscard]] bool operator==(const EdgeCounts&) const = default;

  /// Closed and consistently oriented: there are edges, and every one is used twice, once in each
  /// direction.
  [[nodiscard]] bool closed() const {
    return !none && open == 0 && non_manifold == 0 && flipped == 0;
  }
};

/// A triangle whose corners are in the places of an earlier one's.
struct TriangleCopy {
  TriangleId triangle = 0;
  TriangleId original = 0;  ///< the first triangle with these corners

  [[nodiscard]] bool operator==(const TriangleCopy&) const = default;

  [[nodiscard]] bool operator<(const TriangleCopy& c) const { return triangle < c.triangle; }
};

/// A vertex in the place of an earlier one that triangles use.
struct VertexCopy {
  std::uint32_t vertex = 0;
  std::uint32_t original = 0;  ///< the first used vertex in this place

  [[nodiscard]] bool operator==(const VertexCopy&) const = default;

  [[nodiscard]] bool operator<(const VertexCopy& c) const { return vertex < c.vertex; }
};

/// An edge, named by the first triangle that uses it.
struct EdgePlace {
  TriangleId triangle = 0;
  std::uint32_t corner = 0;  ///< the edge runs from this corner (0 to 2) to the next one
  TriangleId other = 0;      ///< the second triangle that uses it; `triangle` where there is none
  std::uint32_t uses = 0;    ///< proper triangles that use it

  [[nodiscard]] bool operator==(const EdgePlace&) const = default;

  [[nodiscard]] bool operator<(const EdgePlace& e) const {
    return triangle != e.triangle ? triangle < e.triangle : corner < e.corner;
  }
};

/// Where defects are: the first of each kind, by number of triangle or vertex.
struct DefectPlaces {
  std::vector<TriangleId> repeated_corner;
  std::vector<TriangleId> collinear;
  std::vector<TriangleCopy> duplicate;
  std::vector<TriangleCopy> doubled;
  std::vector<EdgePlace> open_edges;
  std::vector<EdgePlace> non_manifold_edges;
  std::vector<EdgePlace> flipped_edges;
  std::vector<std::uint32_t> unused_vertices;
  std::vector<VertexCopy> repeated_vertices;

  [[nodiscard]] bool operator==(const DefectPlaces&) const = default;
};

/// Counts of a mesh's defects, and the first places of each. Vertices are joined by equal position
/// (-0 equals 0), as files often repeat them; `by_index` alone is about the mesh as it is stored.
struct Defects {
  std::uint64_t degenerate = 0;  ///< triangles whose corners are exactly collinear
  /// Of these, triangles with two or three corners in one place.
  std::uint64_t repeated_corner = 0;
  std::uint64_t duplicate = 0;  ///< triangles with the corners of an earlier one
  /// Of these, triangles with area that turn against every earlier one with their corners.
  std::uint64_t doubled = 0;
  std::uint64_t open_edges = 0;          ///< edges used by exactly one proper triangle
  std::uint64_t non_manifold_edges = 0;  ///< edges used by more than two proper triangles
  std::uint64_t flipped_edges = 0;       ///< edges that two triangles use in the same direction
  std::uint64_t unused_vertices = 0;     ///< vertices of no triangle
  std::uint64_t repeated_vertices = 0;   ///< used vertices in the place of an earlier used one
  EdgeCounts by_index;                   ///< edges where vertices are joined by number only
  /// Edges of each part by itself, joined by position; empty unless requested, and where parts hold
  /// one another so often that triangles would be looked at more than 64 times.
  std::vector<EdgeCounts> parts;
  DefectPlaces places;

  [[nodiscard]] bool operator==(const Defects&) const = default;

  /// Degenerate triangles whose corners are in three places on a line.
  [[nodiscard]] std::uint64_t collinear() const { return degenerate - repeated_corner; }

  /// Closed and consistently oriented: a triangle has area, and no edge is open, non-manifold or
  /// flipped.
  [[nodiscard]] bool closed() const {
    return !by_index.none && open_edges == 0 && non_manifold_edges == 0 && flipped_edges == 0;
  }
};

/// Options of `find_defects`.
struct DefectOptions {
  std::size_t places = 10;  ///< most places of each kind to name
  bool parts = true;        ///< count the edges of each part by itself, too

  [[nodiscard]] bool operator==(const DefectOptions&) const = default;
};

/// Counts the defects of a mesh, and names the first of each kind. Degenerate triangles are
/// reported exactly; they count as such and as duplicates, and their edges are left out.
/// \pre     `check(mesh)` passes.
/// \errors  ErrorKind::cancelled.
/// \cost    Sorting by counting: O(n) time on meshes as they are (O(n log n) where all meet in one
///          vertex). At most 25 bytes a triangle and 12 a vertex, and 48 a place.
/// \threads `limits` gives progress and cancellation; the work is one thread's.
[[nodiscard]] Defects find_defects(const MeshView& mesh, const DefectOptions& options = {},
                                   const Limits& limits = {});

}  // namespace soms
