/// \file
/// Values of little-endian files.
#pragma once

#include "soms/base/portable.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace soms::detail {

/// The value stored at byte `at`. \pre All its bytes exist.
template <class T>
[[nodiscard]] T little_endian(std::string_view bytes, std::size_t at) {
  using Bits = std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint32_t>;
  static_assert(sizeof(T) == sizeof(Bits));
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    bits |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return bit_cast<T>(static_cast<Bits>(bits));
}

}  // namespace soms::detail
