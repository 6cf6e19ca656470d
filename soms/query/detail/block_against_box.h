/// \file
/// Triangles of a block against a box, in float: a large leaf beside a small node. A bit that is
/// not set means surely apart; one that is set decides nothing. relative_pose.h proves the margins.
#pragma once

#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms::detail {

/// A box about the origin of x's node, as blocks of y see it. What is at most `reach` apart, in
/// units of y, counts as meeting.
[[nodiscard]] SeenBox seen_by_y(const BoxRelation& relation, const std::array<float, 3>& half_x,
                                float reach);

/// A box about the origin of y's node, as blocks of x see it.
[[nodiscard]] SeenBox seen_by_x(const BoxRelation& relation, const std::array<float, 3>& half_y,
                                float reach);

/// Triangles of y's block against a box about the origin of x's node: bit k for lane k. Seven
/// axes: three of each, and the triangle's normal. What is at most `reach` apart, in units of y,
/// counts as meeting: near_pose.h proves that a limit of nearness is enough.
[[nodiscard]] std::uint32_t box_against_y(const BoxRelation& relation,
                                          const std::array<float, 3>& half_x,
                                          const TriangleBlock& y, float reach = 0);

/// Triangles of x's block against a box about the origin of y's node.
[[nodiscard]] std::uint32_t box_against_x(const BoxRelation& relation, const TriangleBlock& x,
                                          const std::array<float, 3>& half_y, float reach = 0);

}  // namespace soms::detail
