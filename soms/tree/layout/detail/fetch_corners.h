/// \file
/// Reading corners of triangles that lie anywhere in a large mesh.
#pragma once

#include "soms/geometry/mesh.h"

#include <span>

namespace soms::layout {

/// Asks for the corners of all these triangles, so that many are on their way at once: a loop that
/// uses each before it asks for the next waits for each.
inline void fetch_corners(const Mesh& mesh, std::span<const TriangleId> ids) {
  constexpr std::size_t kIndicesAhead = 24;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i + kIndicesAhead < ids.size()) {
      __builtin_prefetch(&mesh.triangles[ids[i + kIndicesAhead]]);
    }
    for (const std::uint32_t corner : mesh.triangles[ids[i]]) {
      __builtin_prefetch(&mesh.vertices[corner]);
    }
  }
}

}  // namespace soms::layout
