/// \file
/// Reading corners of triangles that lie anywhere in a large mesh.
#pragma once

#include "soms/geometry/mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms::layout {

/// Asks for the corners of all these triangles, so that many are on their way at once: a loop that
/// uses each before it asks for the next waits for each.
inline void fetch_corners(const MeshView& mesh, std::span<const TriangleId> ids) {
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

/// The same for a run that is read in order, a few triangles at a time: what comes next is on its
/// way, and what was read has made room in the caches.
class FetchAhead {
 public:
  FetchAhead(const MeshView& mesh, std::span<const TriangleId> ids) : mesh_(mesh), ids_(ids) {}

  /// Call before triangles from place `first` on are read.
  void reach(std::size_t first) {
    const std::size_t far = std::min(ids_.size(), first + kIndicesAhead);
    for (; indices_ < far; ++indices_) {
      __builtin_prefetch(&mesh_.triangles[ids_[indices_]]);
    }
    const std::size_t near = std::min(ids_.size(), first + kCornersAhead);
    for (; corners_ < near; ++corners_) {
      for (const std::uint32_t corner : mesh_.triangles[ids_[corners_]]) {
        __builtin_prefetch(&mesh_.vertices[corner]);
      }
    }
  }

 private:
  static constexpr std::size_t kIndicesAhead = 96;
  static constexpr std::size_t kCornersAhead = 48;

  const MeshView& mesh_;
  std::span<const TriangleId> ids_;
  std::size_t indices_ = 0;  ///< those before are on their way
  std::size_t corners_ = 0;
};

}  // namespace soms::layout
