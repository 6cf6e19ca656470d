#include "soms/query/detail/pair_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::detail {

namespace {

/// Up to so many are sorted by comparing.
constexpr std::size_t kFew = 40;

constexpr unsigned kDigitBits = 8;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
constexpr unsigned kMostPasses = 8;

using Keys = std::span<std::uint64_t>;

std::size_t digit(std::uint64_t key, unsigned pass) {
  return key >> (kDigitBits * pass) & (kDigits - 1);
}

/// Digit by digit, the last one first; `other` has the same size. Returns where the keys ended.
/// \pre `Count` holds the number of keys.
template <typename Count>
Keys sort_keys(Keys keys, Keys other, unsigned bits) {
  const unsigned passes = (bits + kDigitBits - 1) / kDigitBits;
  std::array<std::array<Count, kDigits>, kMostPasses> begins;
  std::fill_n(begins.begin(), passes, std::array<Count, kDigits>{});
  for (const std::uint64_t key : keys) {
    for (unsigned pass = 0; pass < passes; ++pass) {
      ++begins[pass][digit(key, pass)];
    }
  }
  for (unsigned pass = 0; pass < passes; ++pass) {
    Count sum = 0;
    for (Count& begin : begins[pass]) {
      const Count number = begin;
      begin = sum;
      sum += number;
    }
    for (const std::uint64_t key : keys) {
      other[begins[pass][digit(key, pass)]++] = key;
    }
    std::swap(keys, other);
  }
  return keys;
}

}  // namespace

void sort_pairs(std::span<TrianglePair> pairs) {
  TriangleId first = 0;
  TriangleId second = 0;
  for (const auto& [i, j] : pairs) {
    first |= i;
    second |= j;
  }
  // Both numbers side by side, as short as they are.
  const auto bits = static_cast<unsigned>(std::bit_width(second));
  const auto key_of = [bits](const TrianglePair& pair) {
    return std::uint64_t{pair.a} << bits | pair.b;
  };
  const auto write = [&](Keys keys) {
    const std::uint64_t low = (std::uint64_t{1} << bits) - 1;
    std::transform(keys.begin(), keys.end(), pairs.begin(), [&](std::uint64_t key) {
      return TrianglePair{static_cast<TriangleId>(key >> bits), static_cast<TriangleId>(key & low)};
    });
  };
  if (pairs.size() <= kFew) {
    std::array<std::uint64_t, kFew> few;
    const Keys keys = Keys(few).first(pairs.size());
    std::transform(pairs.begin(), pairs.end(), keys.begin(), key_of);
    std::sort(keys.begin(), keys.end());
    write(keys);
    return;
  }
  std::vector<std::uint64_t> memory(2 * pairs.size());
  const Keys keys = Keys(memory).first(pairs.size());
  std::transform(pairs.begin(), pairs.end(), keys.begin(), key_of);
  const unsigned all_bits = bits + static_cast<unsigned>(std::bit_width(first));
  const Keys other = Keys(memory).last(pairs.size());
  const bool few_bits = pairs.size() <= std::numeric_limits<std::uint32_t>::max();
  write(few_bits ? sort_keys<std::uint32_t>(keys, other, all_bits)
                 : sort_keys<std::uint64_t>(keys, other, all_bits));
}

}  // namespace soms::detail
