/// \file
/// References in the order of the cells of a grid, and the upper tree over whole cells.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/build/detail/reference.h"
#include "soms/tree/layout/detail/pages.h"

#include <vector>

namespace soms::detail {

/// The references of one cell, or a single one that is larger than a cell: the upper tree is over
/// these.
struct Cell {
  lanes::Box4 box;
  PrimitiveRange range;  ///< its run in `Cells::references`
};

struct Cells {
  Box bounds;  ///< of the mesh
  layout::Pages<Reference> references;
  layout::Pages<Reference> spare;  ///< as many, of no meaning: memory that is at hand
  std::vector<Cell> cells;
};

/// Makes references of all triangles and sorts them by cell; what fits a subtree is one cell. The
/// same for any number of threads.
[[nodiscard]] Cells sort_into_cells(const MeshView& mesh, const Limits& limits);

/// Brings the cells of the left side to the front by the cheapest plane of area times triangles;
/// returns how many they are. \pre At least two cells.
[[nodiscard]] std::size_t divide_cells(std::span<Cell> cells);

}  // namespace soms::detail
