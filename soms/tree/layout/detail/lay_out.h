/// \file
/// Writing the nodes and blocks of one part once their places are known.
#pragma once

#include "soms/tree/layout/detail/widen.h"

namespace soms::layout {

/// What one wide node is made of. Blocks below it lie side by side.
struct WidePlan {
  std::uint32_t binary = 0;  ///< the node of the part that it stands for
  std::uint32_t count = 0;   ///< lanes
  std::array<std::uint32_t, WideNode::kWidth> slots = {};  ///< nodes of the part, one a lane
  std::array<std::uint32_t, WideNode::kWidth> child = {};  ///< wide nodes or first blocks, likewise
  std::uint32_t first_block = 0;
  std::uint32_t end_block = 0;
};

/// What a part becomes; indices count from its own first wide node and block.
struct PartPlan {
  std::vector<WidePlan> nodes;  ///< parents before children; empty if the part is one leaf
  std::uint32_t blocks = 0;
  std::uint32_t root = 0;  ///< node of the part that its first wide node or leaf stands for
  std::uint32_t node_base = 0;
  std::uint32_t block_base = 0;
};

/// Boxes of the lanes about the node's origin, and by how much each gives way.
struct Lanes {
  std::array<Box, WideNode::kWidth> box;
  std::array<double, WideNode::kWidth> give = {};
};

/// Rounds lanes outward into a node whose count, origin and axes are set.
void store(const Lanes& lanes, WideNode& node);

/// Places a node above the parts, of which `node.count` is set: boxes along the mesh's axes about
/// the middle of all of them, `whole`.
void store_upper(const Box& whole, std::span<const Box> boxes, const Frame& frame, WideNode& node);

/// Blocks of a leaf.
[[nodiscard]] inline std::uint32_t blocks_for(std::uint32_t triangles) {
  return (triangles + TriangleBlock::kWidth - 1) / TriangleBlock::kWidth;
}

/// Makes lane `k` a leaf of `triangles`.
inline void set_leaf(WideNode& node, std::uint32_t k, std::uint32_t block,
                     std::uint32_t triangles) {
  node.child[k] =
      WideNode::kLeafBit | block | (triangles > TriangleBlock::kWidth ? WideNode::kRunBit : 0);
  node.leaves = static_cast<std::uint8_t>(node.leaves | 1U << k);
}

/// Writes a part's blocks and nodes; its corners had better be in the caches. Child nodes count
/// from `plan.node_base`.
void lay_out(const Part& part, const PartPlan& plan, std::span<const TriangleId> primitives,
             const Mesh& mesh, const Frame& frame, std::span<WideNode> nodes,
             std::span<TriangleBlock> blocks);

}  // namespace soms::layout
