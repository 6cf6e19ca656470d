/// \file
/// Points of the unit circle that are the same bits on every machine.
#pragma once

#include <cmath>
#include <cstddef>

namespace soms::detail {

/// Cosine and sine of one angle.
struct OnCircle {
  double cosine = 1;
  double sine = 0;
};

/// Cosine and sine of an angle in turns. Only rounded additions and multiplications, in a fixed
/// order: mathematical libraries differ in the last bit, and golden meshes must not.
[[nodiscard]] inline OnCircle on_circle(double turns) {
  const double whole = turns - std::floor(turns);
  const int quarter = static_cast<int>(std::floor(4 * whole + 0.5));
  const double a = (whole - 0.25 * quarter) * 6.283185307179586;
  const double square = a * a;
  // Taylor's series for |a| at most pi / 4; the first term left out is below 2^-60.
  double cosine = 1;
  double sine = 1;
  for (int k = 18; k >= 2; k -= 2) {
    cosine = 1 - cosine * square / static_cast<double>(k * (k - 1));
    sine = 1 - sine * square / static_cast<double>(k * (k + 1));
  }
  sine *= a;
  switch (quarter % 4) {
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    case 3:
      return {sine, -cosine};
    default:
      return {cosine, sine};
  }
}

/// Point `i` of `n` equally spaced ones.
[[nodiscard]] inline OnCircle on_circle(std::size_t i, std::size_t n) {
  return on_circle(static_cast<double>(i) / static_cast<double>(n));
}

}  // namespace soms::detail
