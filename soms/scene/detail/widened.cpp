#include "soms/scene/detail/widened.h"

#include "soms/base/pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace soms::detail {

Box widened(const Box& box, double margin) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (box.empty()) {
    return box;
  }
  Box wide;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wide.lower[axis] =
        std::max(std::nextafter(box.lower[axis] - margin, -kInfinity), -kMaxCoordinate);
    wide.upper[axis] =
        std::min(std::nextafter(box.upper[axis] + margin, kInfinity), kMaxCoordinate);
  }
  return wide;
}

}  // namespace soms::detail
