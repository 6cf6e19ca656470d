#include "soms/io/detail/base64.h"

#include <array>
#include <cstdint>

namespace soms::detail {

namespace {

constexpr std::uint8_t kNoLetter = 64;

constexpr std::array<std::uint8_t, 256> kValues = [] {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  values.fill(kNoLetter);
  for (std::size_t i = 0; i < kLetters.size(); ++i) {
    values[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}();

}  // namespace

std::optional<std::size_t> decode_base64(std::string_view text, char* to, const Limits& limits) {
  if (text.size() % 4 == 0) {
    for (int i = 0; i < 2 && text.ends_with('='); ++i) {
      text.remove_suffix(1);
    }
  }
  constexpr std::size_t kGroup = 4;
  constexpr std::size_t kLettersPerTick = std::size_t{1} << 22;
  std::size_t size = 0;
  for (std::size_t at = 0; at < text.size(); at += kGroup) {
    if (at % kLettersPerTick == 0) {
      check(limits);
    }
    const std::string_view group = text.substr(at, kGroup);
    std::uint32_t bits = 0;
    std::uint8_t most = 0;
    for (std::size_t i = 0; i < kGroup; ++i) {
      const std::uint8_t value =
          i < group.size() ? kValues[static_cast<unsigned char>(group[i])] : std::uint8_t{0};
      most |= value;
      bits = bits << 6 | value;
    }
    if ((most & kNoLetter) != 0 || group.size() == 1) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i + 1 < group.size(); ++i) {
      to[size++] = static_cast<char>(bits >> (16 - 8 * i) & 0xff);
    }
  }
  return size;
}

}  // namespace soms::detail
