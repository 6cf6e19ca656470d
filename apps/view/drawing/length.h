/// \file
/// Lengths for drawing, rounded; answers never depend on them.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <cmath>

namespace soms::view {

/// Length of a vector, also where its square would overflow or vanish.
[[nodiscard]] inline double length(const Vec3& v) {
  return std::hypot(v.x, v.y, v.z);
}

/// Diagonal of a box; 0 of an empty one.
[[nodiscard]] inline double diagonal(const Box& box) {
  return box.empty() ? 0 : length(box.extent());
}

}  // namespace soms::view
