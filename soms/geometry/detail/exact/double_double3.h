/// \file
/// Vectors of double-doubles.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/double_double.h"

#include <array>

namespace soms::detail {

using DoubleDouble3 = std::array<DoubleDouble, 3>;

/// a - b, exactly.
[[nodiscard]] inline DoubleDouble3 difference(const Vec3& a, const Vec3& b) {
  return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
}

[[nodiscard]] inline DoubleDouble3 cross(const DoubleDouble3& a, const DoubleDouble3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[nodiscard]] inline DoubleDouble dot(const DoubleDouble3& a, const DoubleDouble3& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

}  // namespace soms::detail
