/// \file
/// Triangles and boxes side by side, for tests of kernels of motions.
#pragma once

#include "soms/base/random.h"
#include "soms/motion/detail/kernels/motion_kernels.h"
#include "soms/motion/detail/parting.h"

#include <algorithm>
#include <span>

namespace soms::test {

/// In the coordinates of their body. \pre There are 1 to 8.
inline detail::TriangleLanes lanes_of(std::span<const Triangle> triangles) {
  detail::TriangleLanes lanes;
  lanes.count = triangles.size();
  for (std::size_t lane = 0; lane < detail::TriangleLanes::kLanes; ++lane) {
    const std::size_t at = std::min(lane, triangles.size() - 1);
    const detail::Corners corners = detail::corners_of(triangles[at]);
    lanes.id[lane] = static_cast<TriangleId>(at);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        lanes.corner[k][axis][lane] = corners[k][axis];
      }
    }
  }
  return lanes;
}

/// Boxes of no size with axes of any direction, all at one point and with one change.
inline detail::SweptBoxes boxes_at(Rng& rng, const Vec3& point, const Vec3& change = {},
                                   double give = 0) {
  detail::SweptBoxes boxes;
  boxes.count = detail::SweptBoxes::kLanes;
  for (std::size_t k = 0; k < 3; ++k) {
    boxes.axis[k] = Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    boxes.direction[k] = detail::direction_of(boxes.axis[k]);
  }
  for (std::size_t lane = 0; lane < boxes.count; ++lane) {
    detail::put_lane(point, lane, boxes.center);
    detail::put_lane(change, lane, boxes.change);
    boxes.give[lane] = give;
  }
  return boxes;
}

}  // namespace soms::test
