/// \file
/// Triangles of a block against a box, and against another block's triangles, in float. A bit that
/// is not set means surely apart; one that is set decides nothing. relative_pose.h proves the
/// margins.
#pragma once

#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms::detail {

/// Triangles of y's block against a box about the origin of x's place: bit k for lane k. Seven
/// axes: three of each, and the triangle's normal.
[[nodiscard]] std::uint32_t box_against_y(const Relation& relation,
                                          const std::array<float, 3>& half_x,
                                          const TriangleBlock& y);

/// Triangles of x's block against a box about the origin of y's place.
[[nodiscard]] std::uint32_t box_against_x(const Relation& relation, const TriangleBlock& x,
                                          const std::array<float, 3>& half_y);

/// Triangles of two blocks, prepared for tests of rows.
class BlockPair {
 public:
  BlockPair(const Relation& relation, const TriangleBlock& x, const TriangleBlock& y);

  /// Triangle `i` of x against those of y in `lanes`, by boxes and both planes: bit k for lane k.
  [[nodiscard]] std::uint32_t row(std::uint32_t i, std::uint32_t lanes) const;

 private:
  using Row = std::array<float, TriangleBlock::kWidth>;

  float margin_;
  const TriangleBlock& y_;
  alignas(16) std::array<Row, 9> x_;        // corners of x in y's axes
  alignas(16) std::array<Row, 3> y_lower_;  // boxes of y's triangles
  alignas(16) std::array<Row, 3> y_upper_;
  alignas(16) std::array<Row, 3> y_normal_;
  alignas(16) std::array<Row, 2> y_plane_;  // interval on the normal, margin included
};

}  // namespace soms::detail
