/// \file
/// The grid of a column sweep.
#pragma once

#include "soms/base/lanes.h"
#include "soms/scene/detail/float_box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace soms::detail {

/// Columns over two axes, and steps along the third. Outer cells go on without end.
struct ColumnGrid {
  /// Steps along the columns.
  static constexpr std::uint32_t kSteps = 1U << 16;

  std::size_t along = 0;
  std::size_t across = 1;
  std::size_t upward = 2;
  std::uint32_t columns_across = 1;
  std::uint32_t columns = 1;
  lanes::F4 origin{};
  lanes::F4 scale{};  ///< cells a unit
  lanes::F4 last{};   ///< cell of each axis

  /// The grid that is expected to cost least, by a sample of the boxes. Nothing if there is no
  /// finite one.
  [[nodiscard]] static std::optional<ColumnGrid> of(std::span<const FloatBox> boxes);

  /// The cell of each axis that holds an end of a box. It never falls where the end grows.
  [[nodiscard]] std::array<std::uint32_t, 4> at(const float* end) const {
    // What is no number, endless less endless, is in the first cell.
    const lanes::F4 cell = lanes::min(lanes::max((load(end) - origin) * scale, lanes::F4{}), last);
    return {static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]),
            static_cast<std::uint32_t>(cell[2]), 0};
  }
};

}  // namespace soms::detail
