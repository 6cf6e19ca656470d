/// \file
/// The broad phase by comparing all pairs: what `BroadPhase` must equal.
#pragma once

#include "soms/scene/broad_phase.h"

#include <span>
#include <vector>

namespace soms::reference {

/// Pairs of boxes that share a point, sorted. \cost O(n^2).
[[nodiscard]] std::vector<BoxPair> meeting_pairs(std::span<const Box> boxes);

}  // namespace soms::reference
