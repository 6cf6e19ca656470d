/// \file
/// Writing the blocks and nodes of one part.
#pragma once

#include "soms/tree/layout/detail/block.h"
#include "soms/tree/layout/detail/fetch_corners.h"
#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/detail/part_plan.h"

namespace soms::layout {

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

/// Writes the blocks of leaves, whose triangles follow each other in `ids`.
class LeafWriter {
 public:
  LeafWriter(const MeshView& mesh, std::span<const TriangleId> ids, const Frame& frame)
      : mesh_(mesh), ids_(ids), frame_(frame), fetch_(mesh, ids) {}

  /// Of `count` triangles from place `first` on; returns their bounds. Writes how the corners of
  /// each block lie about its origin. There are as many blocks and moments as the leaf needs.
  Box write(std::size_t first, std::size_t count, std::span<TriangleBlock> blocks,
            std::span<Moments> moments);

 private:
  const MeshView& mesh_;
  std::span<const TriangleId> ids_;
  const Frame& frame_;
  FetchAhead fetch_;
};

/// The least triangle of some blocks.
[[nodiscard]] TriangleId least_id(std::span<const TriangleBlock> blocks);

/// What a part's blocks tell of its nodes.
struct PartContent {
  std::vector<std::uint32_t> first_block;  ///< blocks before each node; at the end, all
  Pages<Box> boxes;                        ///< of each node
  Pages<Moments> moments;                  ///< of each block
};

/// Writes the blocks of a part, leaf after leaf.
[[nodiscard]] PartContent write_blocks(std::span<const PartNode> part,
                                       std::span<const TriangleId> primitives, const MeshView& mesh,
                                       const Frame& frame, std::span<TriangleBlock> blocks);

/// What nodes are made of.
struct NodeSource {
  std::span<const WidePlan> plan;
  std::span<const Box> boxes;
  std::span<const Moments> moments;
  std::span<const TriangleBlock> blocks;  ///< of the part
  std::uint32_t node_base = 0;            ///< that child nodes count from
  std::uint32_t block_base = 0;           ///< that leaves count from
};

/// Writes a part's nodes, and the least triangle below each.
void write_nodes(const NodeSource& from, const Frame& frame, std::span<WideNode> nodes,
                 std::span<TriangleId> least);

}  // namespace soms::layout
