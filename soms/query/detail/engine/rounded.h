/// \file
/// Doubles as floats on one side of them.
#pragma once

#include <cmath>

namespace soms::detail {

/// At least `x`: what is added outweighs the rounding of a float, of half a unit in the last place
/// or, where floats underflow, 2^-150, and that of the sum. \pre |x| < 2^127.
[[nodiscard]] inline float rounded_up(double x) {
  return static_cast<float>(x + (std::abs(x) * 0x1p-22 + 0x1p-100));
}

/// At most `x`.
[[nodiscard]] inline float rounded_down(double x) {
  return -rounded_up(-x);
}

}  // namespace soms::detail
