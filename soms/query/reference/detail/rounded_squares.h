/// \file
/// Squares of lengths in double, and what twins grant for their rounding.
#pragma once

#include "soms/base/vector.h"

#include <limits>

namespace soms::reference::detail {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Squares of lengths in double round by less than 2^-49 of themselves: two roundings or less in a
/// difference and its square, and two in the sum of three. Squares that underflow lose 2^-1074
/// each.
inline constexpr double kRoundedUp = 1 + 0x1p-48;
inline constexpr double kUnderflown = 0x1p-1070;

[[nodiscard]] inline double square(const Vec3& v) {
  return dot(v, v);
}

}  // namespace soms::reference::detail
