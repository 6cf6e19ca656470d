/// \file
/// What is wrong, or merely noteworthy, about a mesh: counted, never repaired.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms {

/// Counts of a mesh's defects. Vertices are joined by equal position, as files often repeat them.
struct Defects {
  std::uint64_t degenerate = 0;          ///< triangles whose corners are exactly collinear
  std::uint64_t duplicate = 0;           ///< triangles with the corner positions of an earlier one
  std::uint64_t open_edges = 0;          ///< edges used by exactly one proper triangle
  std::uint64_t non_manifold_edges = 0;  ///< edges used by more than two proper triangles
  std::uint64_t flipped_edges = 0;       ///< edges that two triangles use in the same direction
  std::uint64_t unused_vertices = 0;     ///< vertices of no triangle

  [[nodiscard]] bool operator==(const Defects&) const = default;

  /// Closed and consistently oriented: no open, non-manifold or flipped edge.
  [[nodiscard]] bool closed() const {
    return open_edges == 0 && non_manifold_edges == 0 && flipped_edges == 0;
  }
};

/// Counts the defects of a mesh. O(n log n) time, about 100 bytes a triangle.
/// \pre     `check(mesh)` passes.
[[nodiscard]] Defects find_defects(const Mesh& mesh);

}  // namespace soms
