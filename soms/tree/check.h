/// \file
/// Is a tree whole? For tests, and for trees that come from elsewhere.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/tree.h"

#include <string>

namespace soms {

/// Empty if `tree` is a valid tree of `mesh`, else one sentence naming the first fault: every
/// triangle in exactly one leaf, children's runs make up their parent's, each box exactly the
/// bounds of its triangles, ids and depths consistent, depth-first order.
[[nodiscard]] std::string find_fault(const Tree& tree, const MeshView& mesh);

}  // namespace soms
