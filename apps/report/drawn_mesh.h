/// \file
/// A mesh as a page draws it: few enough triangles, in floats around its own middle.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms::report {

/// Where a mesh is to keep all its triangles, if they fit.
struct Detail {
  std::vector<Vec3> points = {};  ///< in the mesh's own coordinates
  double radius = 0;              ///< around each point, measured along the axes
};

/// What may be drawn of a mesh.
struct DrawLimits {
  std::uint64_t triangles = 300'000;
  std::uint64_t bytes = 8'000'000;  ///< of floats and indices
};

/// Corners of what is drawn are (vertex - middle) * scale, rounded to float.
struct DrawnMesh {
  Vec3 middle;
  double scale = 1;
  std::vector<float> vertices;         ///< 3 a vertex
  std::vector<std::uint32_t> indices;  ///< 3 a triangle
  std::vector<TriangleId> sources;     ///< of each triangle: the one of the mesh that it is left of
  std::uint64_t all = 0;               ///< triangles of the mesh

  [[nodiscard]] std::uint64_t triangles() const { return indices.size() / 3; }

  [[nodiscard]] std::uint64_t bytes() const { return 4 * (vertices.size() + indices.size()); }
};

/// The whole mesh where it keeps the limits; equal corners become one, triangles stay in order.
/// Else vertices are drawn together in cells of a grid: each goes to the vertex of its cell that
/// the largest triangles share, and triangles that lose their area, or become the same, are left
/// out. Triangles near `detail` stay as they are as long as they take at most half of the limit.
/// The same bytes for the same input. `scale` is a power of two.
/// \pre `mesh` is checked.
[[nodiscard]] DrawnMesh drawn(const MeshView& mesh, double scale, const DrawLimits& limits,
                              const Detail& detail = {});

}  // namespace soms::report
