/// \file
/// FNV-1a 64: the hash that answers, meshes and trees are compared by.
#pragma once

#include "soms/base/portable.h"

#include <cstdint>

namespace soms {

/// Running FNV-1a 64 hash over little-endian bytes (offset cbf29ce484222325, prime 100000001b3).
class Fnv1a {
 public:
  constexpr void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }

  constexpr void add(std::uint32_t value) {
    for (int i = 0; i < 4; ++i) {
      add_byte(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  }

  constexpr void add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
      add_byte(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  }

  constexpr void add(double value) { add(bit_cast<std::uint64_t>(value)); }

  [[nodiscard]] constexpr std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace soms
