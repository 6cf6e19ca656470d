/// \file
/// The inner loops of a column sweep, for several instruction sets. All find the same pairs in the
/// same order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace soms::detail {

/// Most entries that are compared at once: so many follow the last one, with the greatest key.
inline constexpr std::size_t kSweepLanes = 8;

/// An entry's name: whether its box begins here, along either axis, and the box.
inline constexpr unsigned kNameBits = 30;
inline constexpr std::uint32_t kNames = (std::uint32_t{1} << kNameBits) - 1;

/// A pair is `a << 32 | b`, `a` less than `b`; this bit is set besides if ends that are compared
/// coincide.
inline constexpr std::uint64_t kOpenPair = std::uint64_t{1} << 63;

/// Entries of a grid, in order.
struct SweepEntries {
  const std::int32_t* keys = nullptr;       ///< column, then start
  const std::int32_t* last_keys = nullptr;  ///< column, then end
  const std::uint32_t* names = nullptr;     ///< begins here (2 bits), box (30)
  std::array<const float*, 4> ends{};       ///< across: lower, upper; upward: lower, upper
  const std::int32_t* groups = nullptr;     ///< none: no pair is left out
  std::size_t count = 0;
};

/// How far a sweep has come.
struct SweepPlace {
  std::size_t entry = 0;
  std::size_t other = 0;  ///< what it is to be compared with next, if it was left half done
  std::size_t found = 0;
  std::uint64_t compared = 0;
};

/// Compares entries from `place` on, each with those of its column that start before it ends, and
/// puts the pairs that meet at `pairs`. Stops when all are done, or fewer than `kSweepLanes` of
/// `room` places are left, or more than `most_compared` comparisons were made.
using SweepKernel = void (*)(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                             std::uint64_t most_compared, SweepPlace& place);

/// The kernel for an instruction set of `instruction_sets`, which this processor has.
[[nodiscard]] SweepKernel sweep_kernel(std::string_view instruction_set);

/// The kernel for the instruction set that queries run on.
[[nodiscard]] SweepKernel sweep_kernel();

/// Four at a time, in the compilers' own vector types.
void sweep_by_fours(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                    std::uint64_t most_compared, SweepPlace& place);

#if defined(__x86_64__)
/// Eight at a time. \pre The processor has AVX2.
void sweep_by_eights(const SweepEntries& entries, std::uint64_t* pairs, std::size_t room,
                     std::uint64_t most_compared, SweepPlace& place);
#endif

}  // namespace soms::detail
