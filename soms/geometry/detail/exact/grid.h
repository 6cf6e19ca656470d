/// \file
/// Doubles as whole multiples of one power of two.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/parts/odd.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

namespace soms::detail {

/// The exponent of the coarsest grid that holds all numbers; 0 where all of them are 0.
[[nodiscard]] inline int unit_of(std::span<const Odd> numbers) {
  int unit = std::numeric_limits<int>::max();
  for (const Odd& odd : numbers) {
    unit = odd.number == 0 ? unit : std::min(unit, odd.exponent);
  }
  return unit == std::numeric_limits<int>::max() ? 0 : unit;
}

/// The number in units of 2^unit. \pre It is on the grid.
[[nodiscard]] inline Integer on_grid(const Odd& odd, int unit) {
  return odd.number == 0 ? Integer()
                         : Integer(odd.number, static_cast<std::size_t>(odd.exponent - unit));
}

[[nodiscard]] inline IntegerVec on_grid(const Odd* odds, int unit) {
  return {on_grid(odds[0], unit), on_grid(odds[1], unit), on_grid(odds[2], unit)};
}

/// Puts the three coordinates at `odds`.
inline void put_odds(const Vec3& v, Odd* odds) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    odds[axis] = Odd(v[axis]);
  }
}

}  // namespace soms::detail
