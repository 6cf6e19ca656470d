#include "soms/base/lanes_hash.h"

#include "soms/base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace soms {

namespace {

constexpr std::size_t kLanes = 8;
constexpr std::size_t kStripe = kLanes * sizeof(std::uint64_t);
constexpr std::size_t kPiece = std::size_t{1} << 20;

using Stripe = std::array<std::uint64_t, kLanes>;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93ULL;
  x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93ULL;
  return x ^ (x >> 32);
}

/// Little-endian words, the last of them filled up with zeros.
Stripe read_stripe(std::span<const std::byte> bytes) {
  Stripe stripe = {};
  std::memcpy(stripe.data(), bytes.data(), bytes.size());
  if constexpr (std::endian::native == std::endian::big) {
    for (std::uint64_t& word : stripe) {
      word = __builtin_bswap64(word);
    }
  }
  return stripe;
}

/// Each word is added to the lane beside its own, so no change of one word is lost, and the product
/// of its halves to its own, so changes do not cancel. Keys move on with each stripe: the order of
/// stripes counts. Products of 32 bits by 32 are what every instruction set has for vectors.
/// \source  The accumulation of XXH3 (Collet 2019), with keys of our own.
class Accumulator {
 public:
  Accumulator() {
    for (std::size_t k = 0; k < kLanes; ++k) {
      keys_[k] = mixed(2 * k + 1);
      sums_[k] = mixed(2 * k + 2);
    }
  }

  void add(const Stripe& stripe) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const std::uint64_t keyed = stripe[k] ^ keys_[k];
      sums_[k] += (keyed & 0xffffffffU) * (keyed >> 32) + stripe[k ^ 1];
      keys_[k] += kStep;
    }
  }

  /// The same for whole stripes at `bytes`.
  void add(const std::byte* bytes, std::size_t stripes) {
#ifdef __SSE2__
    constexpr std::size_t kPairs = kLanes / 2;
    __m128i keys[kPairs];  // NOLINT(modernize-avoid-c-arrays): std::array drops its alignment
    __m128i sums[kPairs];  // NOLINT(modernize-avoid-c-arrays)
    std::memcpy(keys, keys_.data(), sizeof keys);
    std::memcpy(sums, sums_.data(), sizeof sums);
    const __m128i step = _mm_set1_epi64x(static_cast<std::int64_t>(kStep));
    for (std::size_t i = 0; i < stripes; ++i) {
      for (std::size_t k = 0; k < kPairs; ++k) {
        __m128i words;
        std::memcpy(&words, bytes + i * kStripe + k * sizeof words, sizeof words);
        const __m128i keyed = _mm_xor_si128(words, keys[k]);
        const __m128i product = _mm_mul_epu32(keyed, _mm_srli_epi64(keyed, 32));
        const __m128i beside = _mm_shuffle_epi32(words, 0x4e);  // the halves change places
        sums[k] = _mm_add_epi64(sums[k], _mm_add_epi64(product, beside));
        keys[k] = _mm_add_epi64(keys[k], step);
      }
    }
    std::memcpy(keys_.data(), keys, sizeof keys);
    std::memcpy(sums_.data(), sums, sizeof sums);
#else
    for (std::size_t i = 0; i < stripes; ++i) {
      add(read_stripe({bytes + i * kStripe, kStripe}));
    }
#endif
  }

  [[nodiscard]] std::uint64_t value(std::uint64_t bytes) const {
    std::uint64_t hash = mixed(bytes);
    for (const std::uint64_t sum : sums_) {
      hash = mixed(hash ^ mixed(sum)) + 0x9e3779b97f4a7c15ULL;
    }
    return hash;
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ULL;

  Stripe keys_;
  Stripe sums_;
};

std::uint64_t hash_of_piece(std::span<const std::byte> bytes) {
  Accumulator sums;
  const std::size_t stripes = bytes.size() / kStripe;
  sums.add(bytes.data(), stripes);
  if (stripes * kStripe < bytes.size()) {
    sums.add(read_stripe(bytes.subspan(stripes * kStripe)));
  }
  return sums.value(bytes.size());
}

}  // namespace

std::uint64_t lanes_hash(std::span<const std::byte> bytes, const Limits& limits) {
  const std::size_t pieces = (bytes.size() + kPiece - 1) / kPiece;
  std::vector<std::uint64_t> hashes(pieces);
  for_each_chunk(bytes.size(), kPiece, limits, [&](std::size_t begin, std::size_t end) {
    hashes[begin / kPiece] = hash_of_piece(bytes.subspan(begin, end - begin));
  });
  std::uint64_t hash = mixed(bytes.size());
  for (const std::uint64_t piece : hashes) {
    hash = mixed(hash ^ piece) + 0x9e3779b97f4a7c15ULL;
  }
  return hash;
}

}  // namespace soms
