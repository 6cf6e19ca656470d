#include "soms/motion/detail/moved_bounds.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

Box moved_bounds(const Pose& pose, const Box& box) {
  if (box.empty()) {
    return {};
  }
  Box moved;
  for (std::size_t row = 0; row < 3; ++row) {
    const double* const r = &pose.m[4 * row];
    const double x0 = r[0] * box.lower.x;
    const double x1 = r[0] * box.upper.x;
    const double y0 = r[1] * box.lower.y;
    const double y1 = r[1] * box.upper.y;
    const double z0 = r[2] * box.lower.z;
    const double z1 = r[2] * box.upper.z;
    moved.lower[row] = ((std::min(x0, x1) + std::min(y0, y1)) + std::min(z0, z1)) + r[3];
    moved.upper[row] = ((std::max(x0, x1) + std::max(y0, y1)) + std::max(z0, z1)) + r[3];
  }
  return moved;
}

}  // namespace soms::detail
