/// \file
/// Convex cells of a plane, cut by segments, in whole numbers.
#pragma once

#include "soms/geometry/detail/plane_form.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace soms::detail {

/// A corner of a cell, and the edge from it to the next one.
struct CellCorner {
  PlanePoint at;
  const PlaneForm* line;
  int inner;  // the form's sign inside the cell
};

/// Its corners in order. Refers to the lines.
using Cell = std::vector<CellCorner>;

/// Signs of a form at the corners of a cell.
struct CornerSigns {
  std::vector<int> signs;
  bool below = false;  ///< there is a negative one
  bool above = false;  ///< there is a positive one
};

[[nodiscard]] CornerSigns signs_at_corners(const PlaneForm& line, const Cell& cell);

/// The part of a cell on one side of a line, given the signs of the corners, of which one at least
/// is `side`.
[[nodiscard]] Cell part_of(const Cell& cell, const std::vector<int>& signs, const PlaneForm& line,
                           int side);

using CellVisit = std::function<bool(const PlanePoint&)>;

/// Calls `visit` with a point inside each part that some of the cuts, tried from the last to the
/// first, leave of a cell, until it returns false. Returns false if it did.
/// \cost Grows with the number of parts times that of the cuts.
bool for_each_part(Cell cell, std::span<const PlaneCut> cuts, std::vector<std::uint32_t> some,
                   const CellVisit& visit);

}  // namespace soms::detail
