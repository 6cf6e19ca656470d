/// \file
/// Triangles that hang together by their vertices.
#pragma once

#include "soms/geometry/detail/parts/buckets.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Triangles that are connected by vertices in one place: the parts, by first triangle.
struct ConnectedParts {
  std::vector<TriangleId> first;       ///< the first triangle of each part
  std::vector<std::uint32_t> part_of;  ///< of each vertex that a triangle uses; others: undefined
};

/// `joined` is what `joined_by_position` gives. Takes `connected_parts_work` of `work`.
[[nodiscard]] ConnectedParts connected_parts(const MeshView& mesh,
                                             const std::vector<std::uint32_t>& joined, Work& work);

/// Loops of `connected_parts`.
[[nodiscard]] std::uint64_t connected_parts_work(const MeshView& mesh);

}  // namespace soms::detail
