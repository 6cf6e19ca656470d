/// \file
/// Boxes grown by a margin, rounded outward.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

namespace soms::detail {

/// A box that holds every point of coordinates up to kMaxCoordinate which differs from a point of
/// `box` by at most `margin` along each axis. So where two surfaces are within D, the box of one
/// widened by D meets the box of the other, and the boxes of both widened by `D / 2` meet. An empty
/// box stays empty.
///
/// An end is the rounded sum, moved one step outward. A rounded sum is off by at most half of that
/// step, and `D / 2`, which is inexact for subnormal numbers alone, by at most half of the smallest
/// step. Sums of subnormal numbers are exact, so the two never add up to more than one step.
/// Ends stop at kMaxCoordinate: no surface lies beyond.
/// \pre  `margin` is finite and at least 0; the ends of `box` are within kMaxCoordinate.
[[nodiscard]] Box widened(const Box& box, double margin);

/// The same with a margin for each axis.
[[nodiscard]] Box widened(const Box& box, const Vec3& margin);

}  // namespace soms::detail
