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

/// Bits of the given columns and slices: bit x + 4 y + 16 z.
[[nodiscard]] inline std::uint64_t mask_of(const QuarterRange& x, const QuarterRange& y,
                                           const QuarterRange& z) {
  const auto run = [](const QuarterRange& range, std::uint32_t step) {
    return (std::uint64_t{2} << (step * range.last)) - (std::uint64_t{1} << (step * range.first));
  };
  // Sums of bits so far apart that their products share none.
  const std::uint64_t columns = run(x, 1) * (run(y, 4) & 0x1111);
  return columns * (run(z, 16) & 0x0001'0001'0001'0001);
}

}  // namespace soms::layout
