/// \file
/// What a cell of a min/max height grid is taken up by: 4 x 4 columns, each of four slices.
#pragma once

#include <array>
#include <cstdint>

namespace soms::layout {

/// Slices divide the range of a cell, `lower` to `upper`, at three heights, closer to its lower
/// end: most of a city lies on the ground.
[[nodiscard]] inline std::array<double, 5> slice_ends(float lower, float upper) {
  const auto low = static_cast<double>(lower);
  const auto high = static_cast<double>(upper);
  const double range = high - low;
  return {low, low + range * 0.25, low + range * 0.5, low + range * 0.75, high};
}

/// Slice of a height: monotone in it, and for any height.
[[nodiscard]] inline std::uint32_t slice_of(double height, const std::array<double, 5>& ends) {
  return (height > ends[1] ? 1U : 0U) + (height > ends[2] ? 1U : 0U) + (height > ends[3] ? 1U : 0U);
}

/// First and last of columns along the two sides of a cell, or of its slices; 0 to 3.
struct QuarterRange {
  std::uint32_t first;
  std::uint32_t last;
};

/// Bits of ranges, at steps of a number of bits.
class RangeBits {
 public:
  explicit constexpr RangeBits(std::uint32_t step) {
    for (std::uint32_t first = 0; first < 4; ++first) {
      for (std::uint32_t last = first; last < 4; ++last) {
        for (std::uint32_t k = first; k <= last; ++k) {
          bits_[4 * first + last] |= std::uint64_t{1} << (step * k);
        }
      }
    }
  }

  [[nodiscard]] std::uint64_t of(const QuarterRange& range) const {
    return bits_[4 * range.first + range.last];
  }

 private:
  std::array<std::uint64_t, 16> bits_ = {};
};

/// Bit x + 4 y + 16 z is that of column x, y and slice z. So these ranges' bits are so far apart
/// that their products are those of all that lies in each of them.
inline constexpr RangeBits kColumnsX(1);
inline constexpr RangeBits kColumnsY(4);
inline constexpr RangeBits kSlices(16);

/// Bits of the given columns and slices.
[[nodiscard]] inline std::uint64_t mask_of(const QuarterRange& x, const QuarterRange& y,
                                           const QuarterRange& z) {
  return kColumnsX.of(x) * kColumnsY.of(y) * kSlices.of(z);
}

}  // namespace soms::layout
