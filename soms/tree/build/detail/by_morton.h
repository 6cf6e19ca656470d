/// \file
/// The builder behind the rule `quick`.
#pragma once

#include "soms/tree/build/detail/subtrees.h"
#include "soms/tree/build_options.h"

namespace soms::detail {

/// Sorts triangles by Morton code; nodes are runs of the sorted codes, divided where the highest
/// bit changes. \source Lauterbach et al. 2009, Fast BVH construction on GPUs; Karras 2012,
/// Maximizing parallelism in the construction of BVHs, octrees, and k-d trees.
[[nodiscard]] Subtrees grow_by_morton(const MeshView& mesh, const BuildOptions& options,
                                      const Limits& limits);

}  // namespace soms::detail
