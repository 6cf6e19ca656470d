#include "soms/motion/detail/widened.h"

#include "soms/base/double_limits.h"
#include "soms/base/pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

Box widened(const Box& box, const Vec3& margin) {
  if (box.empty()) {
    return box;
  }
  Box wide;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wide.lower[axis] =
        std::max(std::nextafter(box.lower[axis] - margin[axis], -kInfinity), -kMaxCoordinate);
    wide.upper[axis] =
        std::min(std::nextafter(box.upper[axis] + margin[axis], kInfinity), kMaxCoordinate);
  }
  return wide;
}

Box widened(const Box& box, double margin) {
  return widened(box, Vec3{margin, margin, margin});
}

}  // namespace soms::detail
