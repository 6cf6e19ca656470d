/// \file
/// A mesh cut into runs of triangles by its parts: for formats whose parts do not nest, and to find
/// the parts of many triangles.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {

/// A run of triangles that have one innermost part.
struct PartRun {
  std::size_t first = 0;
  std::uint32_t part = Part::kNoParent;

  [[nodiscard]] bool operator==(const PartRun&) const = default;
};

/// Runs of all triangles in order, each up to the first triangle of the next; parts may nest. The
/// part of a run is the innermost that holds its triangles, which may continue another; `first_run`
/// of it is the `part_of` of each triangle.
/// \cost O(p log p) for p parts.
[[nodiscard]] std::vector<PartRun> part_runs(const MeshView& mesh);

}  // namespace soms
