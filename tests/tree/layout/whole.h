/// \file
/// Is a layout valid? Checked in long double, with no help from what wrote it.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/layout/detail/wide_tree.h"

namespace soms::test {

/// Fails unless every triangle is in one block, and inside every box above it.
void expect_whole(const WideTree& tree, const MeshView& mesh);

}  // namespace soms::test
