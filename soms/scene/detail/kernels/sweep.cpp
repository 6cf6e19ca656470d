#include "soms/scene/detail/kernels/sweep.h"

#include "soms/base/lanes.h"
#include "soms/query/instruction_set.h"

#include <algorithm>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace soms::detail {

namespace {

using SweepMasks [[gnu::vector_size(16)]] = std::int32_t;

template <typename Lanes, typename Value>
[[nodiscard]] Lanes lanes_at(const Value* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Bit k is set where lane k is.
[[nodiscard]] std::uint32_t bits_of(SweepMasks masks) {
#if defined(__SSE2__)
  __m128 lanes;
  std::memcpy(&lanes, &masks, sizeof lanes);
  return static_cast<std::uint32_t>(_mm_movemask_ps(lanes));
#else
  std::uint32_t bits = 0;
  for (unsigned k = 0; k < 4; ++k) {
    bits |= static_cast<std::uint32_t>(masks[k] != 0) << k;
  }
  return bits;
#endif
}

/// One entry beside four others.
class FourComparisons {
 public:
  FourComparisons(const SweepEntries& in, std::size_t k)
      : in_(in),
        key_(SweepMasks{} + in.keys[k]),
        last_(SweepMasks{} + in.last_keys[k]),
        group_(SweepMasks{} + (in.groups != nullptr ? in.groups[k] : 0)),
        lower_across_(lanes::splat(in.ends[0][k])),
        upper_across_(lanes::splat(in.ends[1][k])),
        lower_upward_(lanes::splat(in.ends[2][k])),
        upper_upward_(lanes::splat(in.ends[3][k])) {}

  /// Lanes that meet, of columns where the overlap begins: where one of the two begins, along
  /// either axis.
  [[nodiscard]] std::uint32_t meeting(std::size_t j, SweepMasks name) const {
    SweepMasks meet = (lanes_at<SweepMasks>(&in_.keys[j]) <= last_) &
                      (lanes_at<lanes::F4>(&in_.ends[0][j]) <= upper_across_) &
                      (lower_across_ <= lanes_at<lanes::F4>(&in_.ends[1][j])) &
                      (lanes_at<lanes::F4>(&in_.ends[2][j]) <= upper_upward_) &
                      (lower_upward_ <= lanes_at<lanes::F4>(&in_.ends[3][j]));
    if (in_.groups != nullptr && group_[0] != 0) {
      meet &= lanes_at<SweepMasks>(&in_.groups[j]) != group_;
    }
    const SweepMasks begin = (lanes_at<SweepMasks>(&in_.names[j]) | name) >> kNameBits;
    return bits_of(meet & (begin == -1));
  }

  /// Lanes none of whose ends coincide with those of the entry.
  [[nodiscard]] std::uint32_t sure(std::size_t j) const {
    return bits_of((lanes_at<SweepMasks>(&in_.keys[j]) < last_) &
                   (key_ < lanes_at<SweepMasks>(&in_.last_keys[j])) &
                   (lanes_at<lanes::F4>(&in_.ends[0][j]) < upper_across_) &
                   (lower_across_ < lanes_at<lanes::F4>(&in_.ends[1][j])) &
                   (lanes_at<lanes::F4>(&in_.ends[2][j]) < upper_upward_) &
                   (lower_upward_ < lanes_at<lanes::F4>(&in_.ends[3][j])));
  }

 private:
  const SweepEntries& in_;
  SweepMasks key_;
  SweepMasks last_;
  SweepMasks group_;
  lanes::F4 lower_across_;
  lanes::F4 upper_across_;
  lanes::F4 lower_upward_;
  lanes::F4 upper_upward_;
};

}  // namespace

void sweep_by_fours(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                    std::uint64_t most_compared, SweepPlace& place) {
  for (std::size_t& k = place.entry; k < entries.count; ++k) {
    std::size_t j = std::max(k + 1, place.other);
    const std::size_t begin = j;
    const std::int32_t last = entries.last_keys[k];
    place.other = 0;
    if (entries.keys[j] > last) {
      continue;
    }
    const FourComparisons comparisons(entries, k);
    const std::uint32_t name = entries.names[k];
    const SweepMasks names = SweepMasks{} + static_cast<std::int32_t>(name);
    for (; entries.keys[j] <= last; j += 4) {
      if (room - place.found < kSweepLanes) {
        place.other = j;
        place.compared += j - begin;
        return;
      }
      std::uint32_t lanes = comparisons.meeting(j, names);
      if (lanes == 0) {
        continue;
      }
      const std::uint32_t sure = comparisons.sure(j);
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::uint32_t>(__builtin_ctz(lanes));
        const std::uint32_t a = name & kNames;
        const std::uint32_t b = entries.names[j + lane] & kNames;
        pairs[place.found++] = (sure >> lane & 1U) != 0 ? 0 : kOpenPair;
        pairs[place.found - 1] |= std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
      }
    }
    place.compared += j - begin;
    if (place.compared > most_compared) {
      ++k;
      return;
    }
  }
}

SweepKernel sweep_kernel(std::string_view instruction_set) {
#if defined(__x86_64__)
  if (instruction_set == "avx2" || instruction_set == "avx512") {
    return sweep_by_eights;
  }
#else
  static_cast<void>(instruction_set);
#endif
  return sweep_by_fours;
}

SweepKernel sweep_kernel() {
  static const SweepKernel chosen = sweep_kernel(instruction_set());
  return chosen;
}

}  // namespace soms::detail
