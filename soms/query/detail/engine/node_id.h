/// \file
/// Node ids and tokens, which traversals keep in place of nodes and leaves: see NodeTask and
/// WideNode::child.
#pragma once

#include "soms/query/detail/kernels/kernels.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <cstdint>

namespace soms::detail {

/// Node id of the root.
inline constexpr std::uint32_t kRootId = 0;

/// Bits of a node id below the node's index.
inline constexpr std::uint32_t kNodeIdShift = 3;

[[nodiscard]] constexpr std::uint32_t node_id_of(std::uint32_t index) {
  return index << kNodeIdShift;
}

/// The node, or the parent of the leaf.
[[nodiscard]] constexpr std::uint32_t index_of(std::uint32_t node_id) {
  return node_id >> kNodeIdShift;
}

/// Whether a leaf is meant: a lane of its parent.
[[nodiscard]] constexpr bool is_lane(std::uint32_t node_id) {
  return (node_id & NodeTask::kLane) != 0;
}

[[nodiscard]] constexpr std::uint32_t lane_of(std::uint32_t node_id) {
  return node_id & (WideNode::kWidth - 1);
}

/// The same without the lane.
[[nodiscard]] constexpr std::uint32_t without_lane(std::uint32_t node_id) {
  return node_id & ~((1U << kNodeIdShift) - 1);
}

/// Node id of what lies in a lane of a node, whose own id is `own`.
[[nodiscard]] inline std::uint32_t child_id(const WideNode& node, std::uint32_t own,
                                            std::uint32_t lane) {
  return (node.leaves >> lane & 1U) != 0 ? own | NodeTask::kLane | lane
                                         : node_id_of(node.child[lane]);
}

/// Where a leaf's first block begins.
[[nodiscard]] constexpr std::uint32_t begin_of(std::uint32_t token) {
  return token & (WideNode::kMost - 1);
}

}  // namespace soms::detail
