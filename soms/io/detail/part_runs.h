/// \file
/// A mesh cut into runs of triangles by its parts, for formats whose parts do not nest.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// A run of triangles that have one innermost part.
struct PartRun {
  std::size_t first = 0;
  std::uint32_t part = Part::kNoParent;
};

/// Runs of all triangles in order, each up to the first triangle of the next; parts may nest.
[[nodiscard]] std::vector<PartRun> part_runs(const Mesh& mesh);

}  // namespace soms::detail
