/// \file
/// Rules that SOMS might have been, if its captions are read otherwise.
#pragma once

#include "soms/tree/rule/split.h"

#include <cstddef>

namespace soms::reproduce {

/// The plane halfway between the two midpoints in the middle of their order on the axis: "the
/// Spatial Midpoint between Midpoints of Two Triangles", the two being those around the object
/// median. If the lower one is also the least of all, the plane is at the next greater midpoint.
/// Fails only where all midpoints agree on the axis. For `build_by` with the axis of the inner box.
/// \source thesis, figure 4.6 by its caption.
[[nodiscard]] Split middle_pair(const SplitNode& node, std::size_t axis);

/// Spatial median, and SOMS on the longest axis of the inner box where spatial median leaves a side
/// empty. For `build_by` with the axis of the outer box. Fails only where all midpoints are equal.
/// \source thesis, chapter 1: others continue by a heuristic where the first rule stops.
[[nodiscard]] Split spatial_then_soms(const SplitNode& node, std::size_t axis);

}  // namespace soms::reproduce
