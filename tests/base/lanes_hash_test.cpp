#include "soms/base/lanes_hash.h"

#include "soms/base/random.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

std::uint64_t mix(std::uint64_t x) {
  for (int i = 0; i < 2; ++i) {
    x ^= x >> 32;
    x *= 0xd6e8feb86659fd93U;
  }
  return x ^ (x >> 32);
}

/// The definition, one word after the other.
std::uint64_t plain_piece(std::span<const std::byte> bytes) {
  std::array<std::uint64_t, 8> keys;
  std::array<std::uint64_t, 8> sums;
  for (std::uint64_t k = 0; k < 8; ++k) {
    keys[k] = mix(2 * k + 1);
    sums[k] = mix(2 * k + 2);
  }
  for (std::size_t word = 0; word < (bytes.size() + 63) / 64 * 8; ++word) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < 8 && 8 * word + i < bytes.size(); ++i) {
      value |= std::to_integer<std::uint64_t>(bytes[8 * word + i]) << (8 * i);
    }
    const std::size_t k = word % 8;
    const std::uint64_t keyed = value ^ keys[k];
    sums[k] += (keyed & 0xffffffffU) * (keyed >> 32);
    sums[k ^ 1] += value;
    keys[k] += 0x9e3779b97f4a7c15U;
  }
  std::uint64_t hash = mix(bytes.size());
  for (const std::uint64_t sum : sums) {
    hash = mix(hash ^ mix(sum)) + 0x9e3779b97f4a7c15U;
  }
  return hash;
}

std::uint64_t plain_hash(std::span<const std::byte> bytes) {
  std::uint64_t hash = mix(bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
    const std::size_t size = std::min(kPiece, bytes.size() - at);
    hash = mix(hash ^ plain_piece(bytes.subspan(at, size))) + 0x9e3779b97f4a7c15U;
  }
  return hash;
}

std::vector<std::byte> random_bytes(Rng& rng, std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::byte& byte : bytes) {
    byte = static_cast<std::byte>(rng.below(256));
  }
  return bytes;
}

TEST(LanesHash, IsItsDefinition) {
  test::for_each_case("lanes hash", 60, [](Rng& rng) {
    const std::vector<std::byte> bytes = random_bytes(rng, rng.below(400));
    EXPECT_EQ(lanes_hash(bytes), plain_hash(bytes)) << bytes.size();
  });
  Rng rng(1);
  const std::vector<std::byte> large = random_bytes(rng, 2 * kPiece + 17);
  for (const std::size_t size : {kPiece - 1, kPiece, kPiece + 1, large.size()}) {
    const auto some = std::span(large).first(size);
    EXPECT_EQ(lanes_hash(some), plain_hash(some)) << size;
    EXPECT_EQ(lanes_hash(some, {.threads = 3}), plain_hash(some)) << size;
  }
}

TEST(LanesHash, IsTheSameOnEveryMachine) {
  std::vector<std::byte> bytes(1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<std::byte>(i * i);
  }
  EXPECT_EQ(lanes_hash({}), mix(0));
  EXPECT_EQ(lanes_hash(bytes), 14341600415781180829U);
}

TEST(LanesHash, EveryBitAndEveryPlaceCounts) {
  Rng rng(2);
  const std::vector<std::byte> bytes = random_bytes(rng, 300);
  const std::uint64_t hash = lanes_hash(bytes);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::vector<std::byte> changed = bytes;
    changed[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(lanes_hash(changed), hash) << bit;
  }
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      std::vector<std::byte> changed = bytes;
      std::swap_ranges(changed.begin() + 64 * static_cast<std::ptrdiff_t>(a),
                       changed.begin() + 64 * static_cast<std::ptrdiff_t>(a + 1),
                       changed.begin() + 64 * static_cast<std::ptrdiff_t>(b));
      EXPECT_NE(lanes_hash(changed), hash) << a << ' ' << b;
    }
  }
  const std::vector<std::byte> zeros(200);
  EXPECT_NE(lanes_hash(std::span(zeros).first(100)), lanes_hash(std::span(zeros).first(101)));
}

}  // namespace
}  // namespace soms
