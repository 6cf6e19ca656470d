/// \file
/// World box of a posed mesh from its own box, in constant time.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"

namespace soms::detail {

/// A box that holds `pose.apply(v)`, as rounded, for every `v` in `box`. No margin is needed: each
/// end is the expression of `Pose::apply` with every product replaced by the least (or greatest)
/// that a vertex in the box can give; rounded products and rounded sums are monotone in their
/// operands, so the end bounds every rounded vertex. The identity gives `box` back.
/// \pre  `check_range(pose, box)` passes, so nothing overflows.
[[nodiscard]] Box moved_bounds(const Pose& pose, const Box& box);

}  // namespace soms::detail
