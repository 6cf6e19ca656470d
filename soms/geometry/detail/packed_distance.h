/// \file
/// A squared distance in whole numbers, kept in little memory.
#pragma once

#include "soms/geometry/detail/exact/exact_distance.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// The numbers of a squared distance in as many words as they need: mostly about a hundred bytes,
/// where an `Integer` alone has two hundred.
class PackedDistance {
 public:
  /// No distance yet.
  PackedDistance() = default;

  explicit PackedDistance(const SquaredDistance& squared);

  [[nodiscard]] bool known() const { return !words_.empty(); }

  /// \pre It is known.
  [[nodiscard]] SquaredDistance unpacked() const;

 private:
  std::vector<std::uint64_t> words_;  // of the numerator, then of the denominator, the least first
  std::uint32_t of_numerator_ = 0;    // so many of them
  int exponent_ = 0;
};

}  // namespace soms::detail
