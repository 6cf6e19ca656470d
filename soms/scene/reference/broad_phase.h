/// \file
/// The broad phase by comparing all pairs: what `BroadPhase` must equal.
#pragma once

#include "soms/scene/broad_phase.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::reference {

/// Pairs of boxes that share a point, sorted, but for those that `BroadPhase::set_filter` with
/// these arguments leaves out. \cost O(n^2 k), k ignored pairs.
[[nodiscard]] std::vector<BoxPair> meeting_pairs(std::span<const Box> boxes,
                                                 std::span<const std::uint32_t> groups = {},
                                                 std::span<const BoxPair> ignored = {});

}  // namespace soms::reference
