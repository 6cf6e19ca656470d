/// \file
/// Which of several open surfaces close each other, where there is no choice.
#pragma once

#include "soms/geometry/detail/parts/disjoint_sets.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Surfaces, by number, and stretches of lines where some of them have odd edges. A union of
/// surfaces is closed if it has an even number of those of each stretch. Finds the least closed
/// unions that share no surface with another one.
class ClosedUnions {
 public:
  explicit ClosedUnions(std::size_t surfaces) : classes_(surfaces), open_(surfaces, 0) {}

  /// The surfaces of a stretch, sorted. One that very many share is passed over: what is then taken
  /// for closed may not be.
  void add(std::span<const std::uint32_t> stretch);

  /// Once all stretches are there: the unions, by their least surfaces. All others are in none.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> solve();

 private:
  [[nodiscard]] std::uint32_t united(std::uint32_t a, std::uint32_t b);
  void reduce(std::vector<std::uint32_t>& stretch);
  void settle();
  void untie();
  void untie(std::span<const std::uint32_t> classes,
             std::span<const std::vector<std::uint32_t>* const> stretches);

  DisjointSets classes_;            ///< surfaces that are in the same closed unions
  std::vector<std::uint8_t> open_;  ///< of the least of a class: it is in no closed union
  std::vector<std::vector<std::uint32_t>> stretches_;  ///< of three classes or more
};

}  // namespace soms::detail
