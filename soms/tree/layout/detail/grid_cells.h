/// \file
/// Where the triangles of a block lie in a grid over their mesh, eight at a time.
#pragma once

#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::layout {

/// A grid's place and steps, in units of the layout.
struct GridFrame {
  std::array<std::size_t, 3> axis = {};  ///< the two of the ground plan, and the third
  std::array<double, 2> corner = {};     ///< of the ground plan
  std::array<double, 2> last = {};       ///< number of the last cell of a row, of a column
  double cells_a_unit = 0;
  double scale = 1;  ///< of the layout
};

/// Cells that triangles reach into, and how far down and up they reach: triangle k in lane k. Lanes
/// not in use repeat the last triangle.
struct GridCells {
  template <class T>
  using Lanes = std::array<T, TriangleBlock::kWidth>;

  std::array<Lanes<std::uint32_t>, 2> from = {};
  std::array<Lanes<std::uint32_t>, 2> to = {};
  Lanes<float> least = {};  ///< rounded down
  Lanes<float> most = {};   ///< rounded up

  [[nodiscard]] bool operator==(const GridCells&) const = default;
};

/// Bounds have a margin for the rounding of the block's corners.
void find_cells(const TriangleBlock& block, const GridFrame& frame, GridCells& cells);

/// The same bytes by the instructions that every processor has.
void find_cells_plainly(const TriangleBlock& block, const GridFrame& frame, GridCells& cells);

}  // namespace soms::layout
