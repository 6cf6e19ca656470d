/// \file
/// A binary tree in parts that are laid out one by one.
#pragma once

#include "soms/base/box.h"
#include "soms/tree/tree.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::layout {

/// A node with more triangles than this is laid out before all others; those below it begin a part,
/// which one thread lays out. A constant, so that the layout cannot depend on the threads.
inline constexpr std::uint32_t kPartTriangles = 8192;

/// A node of a part. Nodes are in depth-first order, and numbers count from the part's root: the
/// left child follows its parent.
struct PartNode {
  std::uint32_t first = 0;   ///< of its entries in `Parts::primitives`
  std::uint32_t count = 0;   ///< triangles below
  std::uint32_t right = 0;   ///< number of the right child; 0 in a leaf
  bool undividable = false;  ///< the rule left one side empty here

  [[nodiscard]] bool is_leaf() const { return right == 0; }
};

/// A node above the parts, or the place of a part.
struct UpperNode {
  std::uint32_t count = 0;
  std::uint32_t left = Node::kNone;  ///< in the same array
  std::uint32_t right = Node::kNone;
  std::uint32_t part = Node::kNone;  ///< number of the part that begins here
};

/// A tree in parts: node 0 of `upper` is the root, and children follow their parents. A part begins
/// at each node of at most kPartTriangles, or without children, below none such.
struct Parts {
  Box bounds;  ///< of the mesh
  std::vector<UpperNode> upper;
  std::vector<std::vector<PartNode>> nodes;  ///< of each part
  std::span<const TriangleId> primitives;
};

/// Where a canonical tree is cut into parts.
struct Cut {
  /// The nodes of a part: from `begin` up to `end` of the tree's.
  struct Range {
    std::uint32_t begin;
    std::uint32_t end;
  };

  std::vector<UpperNode> upper;
  std::vector<Range> parts;
};

/// \pre The tree has a node.
[[nodiscard]] Cut cut(const Tree& tree);

/// The same tree in parts, whose nodes are copied. \pre The tree has a node.
[[nodiscard]] Parts parts_of(const Tree& tree);

}  // namespace soms::layout
