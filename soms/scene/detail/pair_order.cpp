#include "soms/scene/detail/pair_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::uint64_t kPairBits = ~(std::uint64_t{1} << 63);
/// Fewer pairs than this are sorted by comparing.
constexpr std::size_t kLeastPairsByDigits = 256;
constexpr unsigned kWidestDigit = 12;
constexpr std::size_t kMostDigits = std::size_t{1} << kWidestDigit;

/// Both numbers of a pair side by side, of `width` bits each.
[[nodiscard]] std::uint64_t key_of(std::uint64_t pair, unsigned width) {
  return (pair & kPairBits) >> 32 << width | static_cast<std::uint32_t>(pair);
}

/// Puts pairs where `places` says, by the digit from bit `shift` of their keys on.
[[gnu::noinline]] void put(std::span<const std::uint64_t> pairs, unsigned width, unsigned shift,
                           std::uint64_t mask, std::uint32_t* places, std::uint64_t* to) {
  for (const std::uint64_t pair : pairs) {
    to[places[key_of(pair, width) >> shift & mask]++] = pair;
  }
}

/// By digits, the least first, in `kPasses` passes; an odd number, so that the last one ends in
/// `sorted`.
template <unsigned kPasses>
void sort_by_digits(std::span<std::uint64_t> pairs, unsigned width,
                    std::span<std::uint64_t> sorted) {
  const unsigned digit = (2 * width + kPasses - 1) / kPasses;
  const std::uint64_t mask = (std::uint64_t{1} << digit) - 1;
  std::array<std::array<std::uint32_t, kMostDigits>, kPasses> places;
  for (auto& counts : places) {
    std::fill_n(counts.begin(), mask + 1, 0U);
  }
  for (const std::uint64_t pair : pairs) {
    std::uint64_t key = key_of(pair, width);
    for (auto& counts : places) {
      ++counts[key & mask];
      key >>= digit;
    }
  }
  std::span<std::uint64_t> from = pairs;
  std::span<std::uint64_t> to = sorted;
  for (unsigned pass = 0; pass < kPasses; ++pass) {
    std::uint32_t place = 0;
    for (std::uint64_t k = 0; k <= mask; ++k) {
      place += std::exchange(places[pass][k], place);
    }
    put(from, width, pass * digit, mask, places[pass].data(), to.data());
    std::swap(from, to);
  }
}

}  // namespace

void sort_box_pairs(std::span<std::uint64_t> pairs, std::size_t boxes,
                    std::vector<std::uint64_t>& sorted) {
  if (pairs.size() < kLeastPairsByDigits) {
    sorted.assign(pairs.begin(), pairs.end());
    std::sort(sorted.begin(), sorted.end(),
              [](std::uint64_t a, std::uint64_t b) { return (a & kPairBits) < (b & kPairBits); });
    return;
  }
  sorted.resize(pairs.size());
  const auto width = static_cast<unsigned>(std::bit_width(boxes));
  if (2 * width <= 3 * kWidestDigit) {
    sort_by_digits<3>(pairs, width, sorted);
  } else {
    sort_by_digits<5>(pairs, width, sorted);
  }
}

}  // namespace soms::detail
