/// \file
/// Pairs of triangles that kernels judge.
#pragma once

#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// Triangles of two blocks in y's axes, about the origin of y's node: floats that are each off the
/// moved and rounded corners by at most `error` (triangle_pairs.h).
struct alignas(64) TriangleSlot {
  static constexpr std::size_t kErrorRow = 9;
  using Corners = std::array<std::array<float, TriangleBlock::kWidth>, kErrorRow + 1>;

  Corners x;  ///< row 3 * corner + axis, lane; the last row is the error, the same in all lanes
  Corners y;
  /// What `judge_in_double` takes in place of x: corners about their block's origin, in y's units,
  /// where that is seen from y's, and errors of moved corners of x and of corners of y.
  std::array<std::array<float, TriangleBlock::kWidth>, kErrorRow> own;
  std::array<double, 3> offset;
  double error_x;
  double error_y;
  std::array<TriangleId, TriangleBlock::kWidth> id_x;
  std::array<TriangleId, TriangleBlock::kWidth> id_y;
};

/// Floats from a lane of one slot to that of the next.
inline constexpr std::size_t kSlotFloats = sizeof(TriangleSlot) / sizeof(float);

/// Most pairs of triangles that are judged at once.
inline constexpr std::size_t kJudged = 16;

/// Pairs of triangles, one a bit: surely overlapping, and those that floats cannot decide. All
/// others are surely apart.
struct Verdicts {
  std::uint32_t hit;
  std::uint32_t open;
};

}  // namespace soms::detail
