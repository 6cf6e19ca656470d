/// \file
/// What single overlap queries and batches share.
#pragma once

#include "soms/query/detail/collector.h"
#include "soms/query/overlap.h"
#include "soms/tree/layout/wide_tree.h"

namespace soms::detail {

/// True if a pair of trees is seen in the axes of `a`: the larger one, and of the coarser unit.
[[nodiscard]] bool first_is_reference(const WideTree& a, const WideTree& b);

[[nodiscard]] bool is_empty(const Shape& shape);

/// One of two shapes at least is compact.
[[nodiscard]] bool any_compact(const Shape& a, const Shape& b);

/// Throws unless the pose is rigid and keeps the shape within range.
void check_pose(const Pose& pose, const Shape& shape);

/// Coverage of a traversal that ended with `collector`; `late` if a deadline ended it.
[[nodiscard]] Coverage coverage_of(OverlapMode mode, const Collector& collector, bool late);

}  // namespace soms::detail
