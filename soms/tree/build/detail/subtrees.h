/// \file
/// A canonical tree in parts, as builders leave it.
#pragma once

#include "soms/base/limits.h"
#include "soms/tree/layout/detail/parts.h"
#include "soms/tree/tree.h"

#include <span>
#include <vector>

namespace soms::detail {

/// Nodes with more triangles are divided one by one; the others become subtrees, each built by one
/// thread. A constant, so that it cannot depend on the threads.
inline constexpr std::uint32_t kSubtreeTriangles = layout::kPartTriangles;

/// A node of a subtree.
using layout::PartNode;

/// A node above the subtrees, or the place of one.
struct Upper {
  Node node;                            ///< children are places in the same array
  std::uint32_t subtree = Node::kNone;  ///< number of the subtree below, or kNone
};

/// Upper node 0 is the root. A subtree begins at each node of at most kSubtreeTriangles, or without
/// children, below none such. Builders leave boxes to whoever looks at them first.
struct Subtrees {
  Box bounds;  ///< of the mesh
  std::vector<Upper> upper;
  std::vector<std::vector<PartNode>> nodes;
  std::vector<TriangleId> ids;  ///< in ascending order in each leaf
};

/// A child with its place and count; bounds are found later.
[[nodiscard]] Node child_of(const Node& parent, bool right, std::uint32_t first,
                            std::uint32_t count);

/// `limits` with progress mapped to a part of the whole.
[[nodiscard]] Limits within(const Limits& limits, double from, double to);

/// Puts the ids of each leaf in ascending order.
void order_leaves(std::span<const PartNode> subtree, std::span<TriangleId> ids);

/// One tree in depth-first order, with all bounds.
[[nodiscard]] Tree join(Subtrees subtrees, const MeshView& mesh, const Limits& limits);

/// The subtrees as layouts take them, which find bounds; `ids` must outlive them.
[[nodiscard]] layout::Parts parts_of(Subtrees& subtrees);

}  // namespace soms::detail
