/// \file
/// The least triangle below each node of a layout.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/layout/pages.h"
#include "soms/tree/layout/wide_tree.h"

#include <span>

namespace soms::layout {

/// For each node, the least number of a triangle below it. \pre Children follow their nodes.
/// \cost O(n)
[[nodiscard]] Pages<TriangleId> least_ids(std::span<const WideNode> nodes,
                                          std::span<const TriangleBlock> blocks);

}  // namespace soms::layout
