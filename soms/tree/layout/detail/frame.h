/// \file
/// Place and unit that the floats of a layout are relative to.
#pragma once

#include "soms/base/box.h"
#include "soms/base/portable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace soms::layout {

/// Least float not below `x`, for |x| < 2^127.
[[nodiscard]] inline float rounded_up(double x) {
  const auto f = static_cast<float>(x);
  if (static_cast<double>(f) >= x) {
    return f;
  }
  // The next float up: its bits count away from zero.
  const auto bits = bit_cast<std::int32_t>(f);
  return bit_cast<float>(bits + (f >= 0 ? 1 : -1));
}

/// Place and unit that the floats of a layout are relative to.
struct Frame {
  Vec3 origin;
  double scale = 1;
  double size = 0;  ///< longest side of the mesh's box, in units of the layout

  [[nodiscard]] std::array<double, 3> middle(const Box& box) const {
    const Vec3 lower = box.lower - origin;
    const Vec3 upper = box.upper - origin;
    return {0.5 * (lower.x + upper.x), 0.5 * (lower.y + upper.y), 0.5 * (lower.z + upper.z)};
  }

  /// A point about a node's origin, in units of the layout.
  [[nodiscard]] Vec3 local(const Vec3& v, const std::array<double, 3>& node) const {
    return ((v - origin) - Vec3{node[0], node[1], node[2]}) * scale;
  }

  /// By how much a box of points about a node's origin gives way. A coordinate has seen two
  /// subtractions, u64 of the mesh's size (to the tree's origin) and u64 of itself (to the node's),
  /// a product with axes that adds 3 u64 of the 1-norm, and two sums more; 2^-130 is for what
  /// underflows. Oriented axes Q are orthonormal to 2^-23 only, so what Q^T gives is off the
  /// coordinates a in Q a = v by 2^-23 of the 1-norm.
  [[nodiscard]] double doubt(double norm, bool oriented) const {
    return (oriented ? 0x1p-22 : 0x1p-49) * norm + 0x1p-50 * size + 0x1p-130;
  }
};

}  // namespace soms::layout
