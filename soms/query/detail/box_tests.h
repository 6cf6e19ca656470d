/// \file
/// Boxes of two trees against each other on six axes: the three of each. A bit that is not set
/// means surely apart; relative_pose.h proves the margins.
#pragma once

#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms::detail {

/// A box about the origin of x's place, with half sides `half`, against the boxes of y's node: bit
/// k for lane k.
[[nodiscard]] std::uint32_t one_against_four(const Relation& relation,
                                             const std::array<float, 3>& half, const WideNode& y);

/// The boxes of x's node against a box about the origin of y's place: bit k for lane k.
[[nodiscard]] std::uint32_t four_against_one(const Relation& relation, const WideNode& x,
                                             const std::array<float, 3>& half);

/// All boxes of two nodes: bit 4 r + k for lane k of x and lane (k + r) mod 4 of y.
[[nodiscard]] std::uint32_t four_against_four(const Relation& relation, const WideNode& x,
                                              const WideNode& y);

}  // namespace soms::detail
