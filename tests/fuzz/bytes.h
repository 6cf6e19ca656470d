/// \file
/// Reads a fuzzer's input as numbers. A spent input gives zeros, so every input means something.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

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

  std::uint64_t eight() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) {
      bits = bits << 8 | byte();
    }
    return bits;
  }

  /// Any double at all.
  double any_double() { return std::bit_cast<double>(eight()); }

  /// All that is left, as text.
  [[nodiscard]] std::string_view rest() const {
    return {reinterpret_cast<const char*>(rest_.data()), rest_.size()};
  }

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
