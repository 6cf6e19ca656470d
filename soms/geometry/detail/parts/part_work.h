/// \file
/// What it costs to look at every part of a mesh.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>
#include <optional>

namespace soms::detail {

/// Triangles to look at for all parts; nothing where parts overlap so often that it would be too
/// many.
[[nodiscard]] inline std::optional<std::uint64_t> part_work(const MeshView& mesh) {
  std::uint64_t triangles = 0;
  for (const Part& part : mesh.parts) {
    triangles += part.count;
  }
  return triangles <= 64 * std::uint64_t{mesh.triangles.size()} ? std::optional(triangles)
                                                                : std::nullopt;
}

}  // namespace soms::detail
