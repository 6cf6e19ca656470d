/// \file
/// A double as a whole number.
#pragma once

#include "soms/base/portable.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace soms::detail {

/// number * 2^exponent, the number odd or 0.
struct Odd {
  std::int64_t number = 0;
  int exponent = 0;

  constexpr Odd() = default;

  /// \pre `value` is finite.
  constexpr explicit Odd(double value) {
    const auto bits = bit_cast<std::uint64_t>(value);
    const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
    constexpr std::uint64_t kHidden = std::uint64_t{1} << 52;
    const std::uint64_t mantissa = (bits & (kHidden - 1)) | (biased == 0 ? 0 : kHidden);
    if (mantissa == 0) {
      return;
    }
    const int zeros = std::countr_zero(mantissa);
    number = static_cast<std::int64_t>(mantissa >> zeros);
    number = bits >> 63 != 0 ? -number : number;
    exponent = std::max(biased, 1) - 1075 + zeros;
  }
};

}  // namespace soms::detail
