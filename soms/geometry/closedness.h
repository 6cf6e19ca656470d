/// \file
/// Is a surface closed, so that every point off it is inside or outside?
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/geometry/defects.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {

/// Whether some triangles are a closed surface, and what was counted to find out. Vertices are
/// joined by equal position (-0 equals 0); an edge has ends in two places.
struct PartClosedness {
  /// The boundary of all triangles together, modulo 2, vanishes: on every line, each point but the
  /// edges' ends lies on an even number of odd edges. So a T-junction that leaves no hole is
  /// closed, doubled triangles cancel, and orientation plays no part. Without triangles: true.
  bool closed = true;
  TriangleId first = 0;                ///< the part's first triangle
  std::uint64_t triangles = 0;         ///< triangles of the part
  std::uint64_t degenerate = 0;        ///< of these, triangles without area
  std::uint64_t odd_edges = 0;         ///< edges that an odd number of the triangles use
  std::uint64_t odd_proper_edges = 0;  ///< the same among triangles with area

  [[nodiscard]] bool operator==(const PartClosedness&) const = default;
};

/// Closedness of a mesh and, on request, of its parts.
struct Closedness {
  PartClosedness whole;
  /// The first odd edges of the whole mesh, by triangle and corner; `uses` and `other` count all
  /// triangles, those without area too.
  std::vector<EdgePlace> places;
  /// Triangles that are connected by vertices in one place, a part each, by first triangle.
  std::vector<PartClosedness> connected;
  /// Each of Mesh::parts by itself; empty where parts hold one another so often that triangles
  /// would be looked at more than 64 times.
  std::vector<PartClosedness> parts;

  [[nodiscard]] bool operator==(const Closedness&) const = default;
};

/// Options of `closedness`.
struct ClosednessOptions {
  Pose pose = {};           ///< decided for the vertices where this moves them, rounded
  std::size_t places = 10;  ///< most odd edges to name
  bool connected = false;   ///< decide for each connected part, too
  bool parts = false;       ///< decide for each part of the mesh, too

  [[nodiscard]] bool operator==(const ClosednessOptions&) const = default;
};

/// Decides exactly whether a mesh is closed, and counts and names its odd edges. Edges are counted
/// in the mesh as it is; which parts are connected is decided there, too. Only whether odd edges
/// cover their lines evenly depends on the pose. Where no edge is odd, the mesh is closed at every
/// pose, and a T-junction, whose corner is rounded off its edge, may open.
/// \pre     `check(mesh)` passes.
/// \errors  ErrorKind::not_finite, not_rigid, out_of_range for the pose; cancelled.
/// \cost    O(n) time on meshes as they are, and O(k log k) exact comparisons for k odd edges. At
///          most 25 bytes a triangle and 20 a vertex, up to 300 an odd edge and 48 a connected
///          part; with `parts`, 36 a triangle of the largest part.
/// \threads `limits` gives progress and cancellation; the work is one thread's.
[[nodiscard]] Closedness closedness(const MeshView& mesh, const ClosednessOptions& options = {},
                                    const Limits& limits = {});

/// The mesh without the triangles of connected parts that are open: what is left is closed, and may
/// be nothing. Vertices stay; parts of the mesh keep their names, with the triangles that are left.
/// `pose` is where closedness is decided, as in ClosednessOptions.
/// \errors  As `closedness`.
/// \cost    As `closedness`.
[[nodiscard]] Mesh closed_parts(const MeshView& mesh, const Pose& pose = {},
                                const Limits& limits = {});

}  // namespace soms
