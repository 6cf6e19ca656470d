/// \file
/// A triangle of a leaf against a box of the other tree, one of which moves. Boxes of large
/// triangles say little; their planes say more.
#pragma once

#include "soms/motion/detail/swept_boxes.h"
#include "soms/motion/detail/swept_triangle.h"

#include <cstddef>

namespace soms::detail {

/// When a box that moves and a triangle that rests may meet. \param margin As for `window_of`
[[nodiscard]] TimeWindow window_of(const SweptBoxes& x, std::size_t lane, const Corners& y,
                                   double margin);

/// When a triangle that moves and a box that rests may meet.
[[nodiscard]] TimeWindow window_of(const SweptTriangle& x, const SweptBoxes& y, std::size_t lane,
                                   double margin);

}  // namespace soms::detail
