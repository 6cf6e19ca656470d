/// \file
/// From binary nodes to wide ones, part by part.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/detail/parts.h"
#include "soms/tree/layout/detail/wide_tree.h"

namespace soms::layout {

/// What a layout is made of.
struct Laid {
  Pages<WideNode> nodes;
  Pages<TriangleBlock> blocks;
  Pages<TriangleId> least_ids;  ///< below each node
};

/// Lays a tree with at least one triangle out; parts lie in the tree's order. The same bytes for
/// any numbering of upper nodes and parts, and any number of threads. \errors
/// ErrorKind::out_of_range beyond 2^28 nodes or blocks; cancelled.
[[nodiscard]] Laid widen(const Parts& tree, const MeshView& mesh, const Frame& frame,
                         const Limits& limits);

}  // namespace soms::layout
