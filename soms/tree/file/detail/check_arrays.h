/// \file
/// What a layout from a file must have before it is traversed.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <string>

namespace soms::detail {

/// Throws unless a traversal of the arrays ends and touches no other memory:
/// - nodes have one to four children; each node but the root is the child of one node before it,
///   and each block belongs to one leaf; so a traversal meets each once, and ends;
/// - triangles, corners, lists and grids name what there is;
/// - all numbers are finite, so that floats of them are no index out of range.
/// With `sound`, also each triangle is in one leaf, and least triangles are right.
/// \errors ErrorKind::bad_file, which names section and index; cancelled.
void check_arrays(const LayoutArrays& arrays, const MeshView& mesh, const std::string& name,
                  bool sound, const Limits& limits);

}  // namespace soms::detail
