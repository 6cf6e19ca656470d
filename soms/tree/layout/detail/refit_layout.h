/// \file
/// Writing the nodes and blocks of a layout once more, over moved vertices.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <span>

namespace soms::layout {

/// Bounds of the corners of all triangles, as `soms::bounds(mesh)`, side by side.
[[nodiscard]] Box bounds_of(const MeshView& mesh, const Limits& limits);

/// Writes a tree's nodes and blocks over a mesh with the same triangles. Nodes are taken apart into
/// the parts that `widen` made, which are laid out as it did.
void refit_layout(const WideTree& tree, const MeshView& mesh, const Frame& frame,
                  const Limits& limits, std::span<WideNode> nodes, std::span<TriangleBlock> blocks);

}  // namespace soms::layout
