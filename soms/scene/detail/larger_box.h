/// \file
/// Boxes made larger along their motion, so that they hold them for calls to come.
#pragma once

#include "soms/scene/detail/float_box.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Means over boxes that moved from one place to another in so many calls.
struct UsualMotion {
  float side = 0;  ///< the longest one
  float way = 0;   ///< the longest of both ends and all axes, in a call
  /// Along each axis, by what part of its side a larger box grows for each call ahead.
  std::array<double, 3> growth{};
};

/// Sides alone if `from` is not as long as `to`.
[[nodiscard]] UsualMotion usual_motion(std::span<const FloatBox> from, std::span<const FloatBox> to,
                                       std::uint64_t calls);

/// For how many more calls larger boxes are made, and what is known of motions.
struct Growth {
  std::uint64_t known_calls = 1;  ///< from where a box was to where it is
  std::uint32_t calls = 0;
  UsualMotion usual;
};

/// A box that was at `from` and is at `to`, made larger for another such motion, and to all sides
/// by as much, at most by a few boxes. An empty box stays as it is.
[[nodiscard]] FloatBox larger_box(const FloatBox& from, const FloatBox& to, const Growth& growth);

/// All boxes made larger, to all sides by a part of their ways.
/// \pre `from` is as long as `to`.
void make_larger(std::span<const FloatBox> from, std::span<const FloatBox> to, const Growth& growth,
                 std::vector<FloatBox>& large);

}  // namespace soms::detail
