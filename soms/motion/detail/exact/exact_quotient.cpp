#include "soms/motion/detail/exact/exact_quotient.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

namespace {

__extension__ using QuotientWord2 = unsigned __int128;

/// How often 2 divides the number. \pre It is not 0.
std::size_t twos_of(const Integer& number) {
  std::size_t at = 0;
  while (number.word(at) == 0) {
    ++at;
  }
  return 64 * at + static_cast<std::size_t>(std::countr_zero(number.word(at)));
}

/// The `count` lowest words of the magnitude over 2^twos.
std::vector<std::uint64_t> words_above(const Integer& number, std::size_t twos, std::size_t count) {
  const std::size_t whole = twos / 64;
  const std::size_t rest = twos % 64;
  std::vector<std::uint64_t> words(count);
  for (std::size_t i = 0; i < count; ++i) {
    words[i] = number.word(whole + i) >> rest |
               (rest == 0 ? 0 : number.word(whole + i + 1) << (64 - rest));
  }
  return words;
}

/// x with x * odd = 1 modulo 2^64: each step of Newton's doubles the bits that are right, from 3.
std::uint64_t inverse_of(std::uint64_t odd) {
  std::uint64_t x = odd;
  for (int bits = 3; bits < 64; bits *= 2) {
    x *= 2 - odd * x;
  }
  return x;
}

}  // namespace

Integer exact_quotient(const Integer& a, const Integer& b) {
  if (a.sign() == 0) {
    return a;
  }
  const std::size_t twos = twos_of(b);
  const std::size_t size = a.size() - b.size() + 1;
  std::vector<std::uint64_t> rest = words_above(a, twos, size);
  const std::vector<std::uint64_t> by = words_above(b, twos, std::min(size, b.size()));
  const std::uint64_t inverse = inverse_of(by[0]);
  // Modulo 2^(64 size), which is above the quotient.
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint64_t word = rest[i] * inverse;
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < by.size() && i + j < size; ++j) {
      const QuotientWord2 product = static_cast<QuotientWord2>(word) * by[j] + carry;
      const auto low = static_cast<std::uint64_t>(product);
      carry = static_cast<std::uint64_t>(product >> 64) + (rest[i + j] < low ? 1 : 0);
      rest[i + j] -= low;
    }
    for (std::size_t j = i + by.size(); j < size && carry != 0; ++j) {
      const std::uint64_t before = rest[j];
      rest[j] -= carry;
      carry = before < carry ? 1 : 0;
    }
    rest[i] = word;
  }
  const Integer magnitude{std::span<const std::uint64_t>(rest)};
  return a.sign() == b.sign() ? magnitude : -magnitude;
}

}  // namespace soms::detail
