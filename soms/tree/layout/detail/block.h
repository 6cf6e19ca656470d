/// \file
/// A leaf's triangles side by side.
#pragma once

#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/detail/node_axes.h"
#include "soms/tree/layout/detail/wide_tree.h"

namespace soms::layout {

/// What is found out about triangles while their block is made.
struct BlockContent {
  Moments moments;  ///< of corners about the block's origin, in units of the layout
  Box bounds;       ///< of the triangles, in the mesh's own numbers
};

/// Fills a block with 1 to 8 triangles; `following` is left to the caller.
BlockContent make_block(const MeshView& mesh, std::span<const TriangleId> ids, const Frame& frame,
                        TriangleBlock& block);

/// The same bytes by the instructions that every processor has.
BlockContent make_block_plainly(const MeshView& mesh, std::span<const TriangleId> ids,
                                const Frame& frame, TriangleBlock& block);

}  // namespace soms::layout
