/// \file
/// The distance of triangles that a plane across an axis parts at their nearest points: what lies
/// above floors and beside walls, where many pairs are exactly as near.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"

#include <optional>

namespace soms::detail {

/// The distance, without error, if a shortest segment runs along an axis; else nothing. Let the
/// triangles be parted along the axis by a gap above 0. No two points of them are nearer than the
/// gap. The distance equals the gap if, seen along the axis, the features that the corners at the
/// gap's two ends span share a point: decided exactly. The gap is a difference of two coordinates.
///
/// Gaps outside [`lower`, `upper`], bounds of the distance, are not looked at any further.
/// \pre Coordinates are finite and of magnitude at most 2^300.
/// \cost A few comparisons where no gap is within the bounds.
[[nodiscard]] std::optional<DoubleDouble> axis_gap(const Triangle& a, const Triangle& b,
                                                   const DoubleDouble& lower,
                                                   const DoubleDouble& upper);

}  // namespace soms::detail
