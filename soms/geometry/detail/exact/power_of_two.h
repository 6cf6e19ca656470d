/// \file
/// Multiplication by powers of two, without the C library's care for numbers that are rarely met.
#pragma once

#include "soms/base/portable.h"

#include <cmath>
#include <cstdint>

namespace soms::detail {

/// std::ldexp(x, exponent), to the bit: a product with a normal power of two is rounded once, too.
[[nodiscard]] inline double times_power_of_two(double x, int exponent) {
  constexpr int kLeast = -1022;
  constexpr int kMost = 1023;
  if (exponent < kLeast || exponent > kMost) {
    return std::ldexp(x, exponent);
  }
  return x * bit_cast<double>(static_cast<std::uint64_t>(exponent + kMost) << 52);
}

/// std::ilogb(x) of a number above 0.
[[nodiscard]] inline int exponent_of(double x) {
  constexpr int kBias = 1023;
  const auto biased = static_cast<int>(bit_cast<std::uint64_t>(x) >> 52);
  return biased == 0 ? std::ilogb(x) : biased - kBias;
}

}  // namespace soms::detail
