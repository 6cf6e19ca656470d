/// \file
/// Trees that differ in balance and in nothing else.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/tree.h"

namespace soms::reproduce {

/// Divides each node's triangles, sorted by their midpoints on the longest axis of the outer box,
/// after the first `share` of them: a half gives object median, less gives the same kind of tree
/// out of balance. Down to one triangle a leaf, whatever depth that takes. Ties by triangle number;
/// at least one triangle goes to either side.
/// \pre 0 < share <= 0.5.
[[nodiscard]] Tree uneven_tree(const MeshView& mesh, double share);

}  // namespace soms::reproduce
