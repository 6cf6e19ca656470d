/// \file
/// The brute-force twin of `bodies_of`: what tests believe.
#pragma once

#include "soms/geometry/bodies_of.h"

#include <vector>

namespace soms::reference {

/// The groups of `bodies_of` that are closed: `closedness` decides for every set of parts.
/// \pre    At most 16 parts are open.
/// \cost   O(2^p n) for p open parts, for each object that holds some.
[[nodiscard]] std::vector<PartGroup> closed_bodies_by_brute_force(const MeshView& mesh);

}  // namespace soms::reference
