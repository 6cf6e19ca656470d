/// \file
/// Trees by a division that the library's rules cannot express: it sees whole triangles.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/tree.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace soms::reproduce {

/// Divides the triangles of a node, two or more: reorders them and returns how many of them go
/// left. 0 leaves the node whole, and the tree notes it as undividable. `outer` is the node's box.
using DivideTriangles =
    std::function<std::uint32_t(std::span<TriangleId> triangles, const Box& outer)>;

/// The first of x, y and z with the greatest extent.
[[nodiscard]] std::size_t longest_axis(const Box& box);

/// The canonical tree by a division, down to one triangle a leaf. Nodes at depth `level` - 1 are
/// not divided; 0 means no limit.
[[nodiscard]] Tree divided_tree(const MeshView& mesh, const DivideTriangles& divide, int level = 0);

}  // namespace soms::reproduce
