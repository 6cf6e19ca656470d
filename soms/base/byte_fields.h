/// \file
/// Numbers and texts as bytes, the least byte first: what our binary files are made of.
#pragma once

#include "soms/base/portable.h"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace soms::detail {

/// Appends an unsigned number.
template <class T>
void put(std::string& bytes, T value) {
  for (std::size_t k = 0; k < sizeof(T); ++k) {
    bytes += static_cast<char>(static_cast<unsigned char>(value >> (8 * k)));
  }
}

inline void put(std::string& bytes, double value) {
  put(bytes, bit_cast<std::uint64_t>(value));
}

/// Appends the length of a text, in 32 bits, and the text.
inline void put_text(std::string& bytes, std::string_view text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

/// The unsigned number at the start of `bytes`.
template <class T>
[[nodiscard]] T get(const char* bytes) {
  T value = 0;
  for (std::size_t k = 0; k < sizeof(T); ++k) {
    value = static_cast<T>(
        value | static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[k])) << (8 * k)));
  }
  return value;
}

/// Takes numbers and texts from the front of bytes that may be short. What is beyond the end is 0
/// or empty, and `failed` is true from then on.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <std::unsigned_integral T>
  [[nodiscard]] T number() {
    const std::string_view taken = take(sizeof(T));
    return taken.empty() ? T{0} : get<T>(taken.data());
  }

  [[nodiscard]] double real() { return bit_cast<double>(number<std::uint64_t>()); }

  [[nodiscard]] std::string text() { return std::string(take(number<std::uint32_t>())); }

  /// The number of items that follow, each of at least `least` bytes: 0 where so many cannot
  /// follow.
  [[nodiscard]] std::uint32_t count(std::size_t least) {
    const auto items = number<std::uint32_t>();
    failed_ = failed_ || items > bytes_.size() / least;
    return failed_ ? 0 : items;
  }

  [[nodiscard]] bool failed() const { return failed_; }

  /// Everything was taken, and nothing was missing.
  [[nodiscard]] bool is_done() const { return !failed_ && bytes_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    failed_ = failed_ || size > bytes_.size();
    if (failed_) {
      return {};
    }
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  std::string_view bytes_;
  bool failed_ = false;
};

}  // namespace soms::detail
