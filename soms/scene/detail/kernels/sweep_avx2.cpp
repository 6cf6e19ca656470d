// AVX2: an entry beside eight others.
#include "soms/scene/detail/kernels/sweep.h"

#if defined(__x86_64__)
#include "soms/query/detail/kernels/target.h"

#include <immintrin.h>

SOMS_TARGET_BEGIN("avx2,popcnt,bmi")

namespace soms::detail {

namespace {

/// Lanes of a set, the first ones first; then any.
struct LanesOfSets {
  alignas(64) std::uint8_t lanes[256][8] = {};

  constexpr LanesOfSets() {
    for (unsigned set = 0; set < 256; ++set) {
      unsigned to = 0;
      for (unsigned lane = 0; lane < 8; ++lane) {
        if ((set >> lane & 1U) != 0) {
          lanes[set][to++] = static_cast<std::uint8_t>(lane);
        }
      }
    }
  }
};

constexpr LanesOfSets kLanesOfSets;

inline __m256i load8(const void* from) {
  return _mm256_loadu_si256(static_cast<const __m256i*>(from));
}

inline std::uint32_t bits8(__m256 mask) {
  return static_cast<std::uint32_t>(_mm256_movemask_ps(mask));
}

/// Puts the pairs of `name` with lanes of `names`; writes eight of them.
inline void put_pairs(std::uint32_t lanes, __m256i name, __m256i names, std::uint64_t* to) {
  const __m256i from = _mm256_cvtepu8_epi32(
      _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kLanesOfSets.lanes[lanes])));
  const __m256i boxes = _mm256_set1_epi32(static_cast<int>(kNames));
  const __m256i a = _mm256_and_si256(name, boxes);
  const __m256i b = _mm256_and_si256(_mm256_permutevar8x32_epi32(names, from), boxes);
  const __m256i first = _mm256_min_epu32(a, b);
  const __m256i second = _mm256_max_epu32(a, b);
  const __m256i even = _mm256_unpacklo_epi32(second, first);  // pairs 0, 1, 4, 5
  const __m256i odd = _mm256_unpackhi_epi32(second, first);   // pairs 2, 3, 6, 7
  auto* const pairs = reinterpret_cast<__m256i*>(to);
  _mm256_storeu_si256(pairs, _mm256_permute2x128_si256(even, odd, 0x20));
  _mm256_storeu_si256(pairs + 1, _mm256_permute2x128_si256(even, odd, 0x31));
}

/// One entry beside eight others; see sweep.cpp.
class EightComparisons {
 public:
  EightComparisons(const SweepEntries& in, std::size_t k)
      : key_(_mm256_set1_epi32(in.keys[k])),
        last_(_mm256_set1_epi32(in.last_keys[k])),
        name_(_mm256_set1_epi32(static_cast<int>(in.names[k]))),
        lower_across_(_mm256_set1_ps(in.ends[0][k])),
        upper_across_(_mm256_set1_ps(in.ends[1][k])),
        lower_upward_(_mm256_set1_ps(in.ends[2][k])),
        upper_upward_(_mm256_set1_ps(in.ends[3][k])) {}

  [[nodiscard]] __m256i name() const { return name_; }

  [[nodiscard]] std::uint32_t meeting(const SweepEntries& in, std::size_t j, __m256i names) const {
    const __m256i after = _mm256_cmpgt_epi32(load8(&in.keys[j]), last_);
    const __m256i begin = _mm256_cmpgt_epi32(  // both of the highest bits are set
        _mm256_srli_epi32(_mm256_or_si256(names, name_), kNameBits), _mm256_set1_epi32(2));
    const __m256 across =
        _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&in.ends[0][j]), upper_across_, _CMP_LE_OQ),
                      _mm256_cmp_ps(lower_across_, _mm256_loadu_ps(&in.ends[1][j]), _CMP_LE_OQ));
    const __m256 upward =
        _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&in.ends[2][j]), upper_upward_, _CMP_LE_OQ),
                      _mm256_cmp_ps(lower_upward_, _mm256_loadu_ps(&in.ends[3][j]), _CMP_LE_OQ));
    return bits8(_mm256_and_ps(_mm256_and_ps(across, upward),
                               _mm256_castsi256_ps(_mm256_andnot_si256(after, begin))));
  }

  [[nodiscard]] std::uint32_t sure(const SweepEntries& in, std::size_t j) const {
    const __m256i along = _mm256_and_si256(_mm256_cmpgt_epi32(last_, load8(&in.keys[j])),
                                           _mm256_cmpgt_epi32(load8(&in.last_keys[j]), key_));
    const __m256 across =
        _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&in.ends[0][j]), upper_across_, _CMP_LT_OQ),
                      _mm256_cmp_ps(lower_across_, _mm256_loadu_ps(&in.ends[1][j]), _CMP_LT_OQ));
    const __m256 upward =
        _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&in.ends[2][j]), upper_upward_, _CMP_LT_OQ),
                      _mm256_cmp_ps(lower_upward_, _mm256_loadu_ps(&in.ends[3][j]), _CMP_LT_OQ));
    return bits8(_mm256_and_ps(_mm256_and_ps(across, upward), _mm256_castsi256_ps(along)));
  }

 private:
  __m256i key_;
  __m256i last_;
  __m256i name_;
  __m256 lower_across_;
  __m256 upper_across_;
  __m256 lower_upward_;
  __m256 upper_upward_;
};

template <bool kGrouped>
inline void sweep_eights(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                         std::uint64_t most_compared, SweepPlace& place) {
  std::size_t found = place.found;
  std::uint64_t compared = place.compared;
  std::size_t k = place.entry;
  std::size_t other = place.other;
  const auto leave = [&](std::size_t entry, std::size_t next) {
    place = {entry, next, found, compared};
  };
  for (; k < entries.count; ++k) {
    std::size_t j = other > k ? other : k + 1;
    const std::size_t begin = j;
    const std::int32_t last = entries.last_keys[k];
    other = 0;
    if (entries.keys[j] > last) {
      continue;
    }
    const EightComparisons comparisons(entries, k);
    const std::int32_t group = kGrouped ? entries.groups[k] : 0;
    for (; entries.keys[j] <= last; j += 8) {
      if (room - found < kSweepLanes) {
        compared += j - begin;
        leave(k, j);
        return;
      }
      const __m256i names = load8(&entries.names[j]);
      std::uint32_t lanes = comparisons.meeting(entries, j, names);
      if (kGrouped && group != 0) {
        lanes &= ~bits8(_mm256_castsi256_ps(
            _mm256_cmpeq_epi32(load8(&entries.groups[j]), _mm256_set1_epi32(group))));
      }
      put_pairs(lanes, comparisons.name(), names, pairs + found);
      std::uint64_t* to = pairs + found;
      found += static_cast<std::size_t>(__builtin_popcount(lanes));
      const std::uint32_t open = lanes & ~comparisons.sure(entries, j);
      for (std::uint32_t left = open != 0 ? lanes : 0; left != 0; left &= left - 1) {
        *to++ |= (open >> __builtin_ctz(left) & 1U) != 0 ? kOpenPair : 0;
      }
    }
    compared += j - begin;
    if (compared > most_compared) {
      leave(k + 1, 0);
      return;
    }
  }
  leave(k, 0);
}

}  // namespace

void sweep_by_eights(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                     std::uint64_t most_compared, SweepPlace& place) {
  if (entries.groups != nullptr) {
    sweep_eights<true>(entries, pairs, room, most_compared, place);
  } else {
    sweep_eights<false>(entries, pairs, room, most_compared, place);
  }
}

}  // namespace soms::detail

SOMS_TARGET_END
#endif
