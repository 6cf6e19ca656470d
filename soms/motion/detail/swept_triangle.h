/// \file
/// Two triangles, one of which moves through a stretch of the way: when can they meet?
#pragma once

#include "soms/motion/detail/motion_interval.h"
#include "soms/motion/detail/parting.h"

namespace soms::detail {

/// A triangle over a stretch of the way: all corners move as their mean does, but for `give`.
struct SweptTriangle {
  Triangle body;    ///< in the coordinates of the body
  Corners corners;  ///< in world, in the middle of the stretch
  TriangleSides sides;
  Vec3 change;  ///< from there to its end
  double give = 0;
};

[[nodiscard]] SweptTriangle swept_triangle(const Triangle& body, const MotionBounds& bounds,
                                           const MotionInterval& interval);

/// When the triangles may be within the clearance. `sides` are those of `y`.
/// \param margin As MotionBounds::box_margin
[[nodiscard]] TimeWindow window_of(const SweptTriangle& x, const Corners& y,
                                   const TriangleSides& sides, double margin);

}  // namespace soms::detail
