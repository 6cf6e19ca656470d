/// \file
/// The builder behind the rules `fast` and `quality`.
#pragma once

#include "soms/tree/build/detail/subtrees.h"
#include "soms/tree/build_options.h"

namespace soms::detail {

/// Divides boxes in float: first whole cells of a grid, then the triangles of each subtree.
[[nodiscard]] Subtrees grow_by_reference(const MeshView& mesh, const BuildOptions& options,
                                         const Limits& limits);

}  // namespace soms::detail
