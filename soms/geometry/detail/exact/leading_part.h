/// \file
/// From whole numbers of any length back to doubles.
#pragma once

#include "soms/geometry/detail/exact/double_double.h"
#include "soms/geometry/detail/exact/integer.h"

#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// value * 2^exponent.
struct LeadingPart {
  DoubleDouble value;
  int exponent = 0;
};

/// The number but for less than 2^-103 of it: its three leading words. The value is below 2^192.
[[nodiscard]] inline LeadingPart leading_part(const Integer& number) {
  const std::size_t size = number.size();
  const std::size_t words = size < 3 ? size : 3;
  DoubleDouble value;
  for (std::size_t i = 0; i < words; ++i) {
    const std::uint64_t word = number.word(size - 1 - i);
    value = value * 0x1p64 + (DoubleDouble(static_cast<double>(word >> 32) * 0x1p32) +
                              static_cast<double>(word & 0xffffffffU));
  }
  return {number.sign() < 0 ? -value : value, 64 * static_cast<int>(size - words)};
}

}  // namespace soms::detail
