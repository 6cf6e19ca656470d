/// \file
/// Reads a fuzzer's input as numbers. A spent input gives zeros, so every input means something.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms::fuzz {

class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  [[nodiscard]] bool spent() const { return rest_.empty(); }

  std::uint8_t byte() {
    if (rest_.empty()) {
      return 0;
    }
    const std::uint8_t first = rest_.front();
    rest_ = rest_.subspan(1);
    return first;
  }

  /// In [0, n), by one byte; n at most 256.
  std::uint32_t below(std::uint32_t n) { return byte() % n; }

  /// In [-1, 1], by three bytes: a multiple of 2^-23.
  double fraction() {
    const std::uint32_t high = byte();
    const std::uint32_t middle = byte();
    const auto bits = static_cast<std::int32_t>(high << 16 | middle << 8 | byte());
    return std::ldexp(bits - 0x800000, -23);
  }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace soms::fuzz
