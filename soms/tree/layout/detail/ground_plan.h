/// \file
/// The ground plan of a flat mesh, divided into columns.
///
/// Proof. A coordinate's column is found by steps of which each is monotone in it, rounding
/// included: less a number, times a positive one, cut to a range, cut to an integer. So intervals
/// that share a number have a column in common, and so have they where columns are joined by powers
/// of two.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::layout {

/// A box above a ground plan: first and last columns along either axis, and its heights.
struct PlanBox {
  std::array<std::uint32_t, 2> from;
  std::array<std::uint32_t, 2> to;
  double lower;
  double upper;
};

/// All coordinates are in units of the layout, relative to the tree's origin.
struct GroundPlan {
  std::array<std::uint8_t, 3> axis = {};  ///< the two of the plan, and that of heights
  std::array<double, 2> origin = {};      ///< lower corner
  std::array<double, 2> last = {};        ///< number of the last column along each axis
  double columns_a_unit = 0;
  double rounding = 0;  ///< 2^-45 of the mesh's size

  [[nodiscard]] bool operator==(const GroundPlan&) const = default;

  /// Column of a coordinate along axis k of the plan.
  [[nodiscard]] std::uint32_t column(std::size_t k, double x) const {
    const double place = (x - origin[k]) * columns_a_unit;
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(place > 0 ? (place < last[k] ? place : last[k]) : 0));
  }

  /// Where a column begins.
  [[nodiscard]] double begin_of(std::size_t k, std::uint64_t column) const {
    return origin[k] + static_cast<double>(column) / columns_a_unit;
  }

  /// Finds a box's place. Not returned: its parts would be copied while they are still on their way
  /// to memory.
  void place(const std::array<double, 3>& center, const std::array<double, 3>& half,
             PlanBox& box) const {
    for (std::size_t k = 0; k < 2; ++k) {
      box.from[k] = column(k, center[axis[k]] - half[axis[k]]);
      box.to[k] = column(k, center[axis[k]] + half[axis[k]]);
    }
    box.lower = center[axis[2]] - half[axis[2]];
    box.upper = center[axis[2]] + half[axis[2]];
  }
};

}  // namespace soms::layout
