/// \file
/// The canonical tree: binary, boxes in double, numbered as in the thesis. It is what is drawn,
/// counted and reproduced; `layout/` converts it to what queries run on.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms {

/// Number of a node by its place: root 0, children 2i+1 (left, odd) and 2i+2 (right, even).
/// \source  thesis, figs. 4.14 to 4.21.
using TreeId = std::uint64_t;

/// TreeId of nodes deeper than 63 levels, whose number needs more than 64 bits.
inline constexpr TreeId kNoTreeId = ~TreeId{0};

/// Greatest depth of a node that has a TreeId.
inline constexpr int kMaxTreeIdDepth = 63;

/// Depth of a node from its TreeId: floor(log2(id + 1)); the root has depth 0 and level 1, and
/// kNoTreeId gives -1.
[[nodiscard]] int depth_of(TreeId id);

/// TreeId of a node's parent, (id - 1) / 2; kNoTreeId for the root and for kNoTreeId.
[[nodiscard]] TreeId parent_of(TreeId id);

/// TreeId of a node's left child, 2 * id + 1 (odd); kNoTreeId where it needs more than 64 bits.
[[nodiscard]] TreeId left_child_of(TreeId id);

/// TreeId of a node's right child, 2 * id + 2 (even); kNoTreeId where it needs more than 64 bits.
[[nodiscard]] TreeId right_child_of(TreeId id);

/// A node of the canonical tree.
struct Node {
  static constexpr std::uint32_t kNone = 0xffffffffU;

  Box bounds;                  ///< outer box: of all corners of the node's triangles
  TreeId id = kNoTreeId;       ///< place in the complete binary tree
  std::uint32_t left = kNone;  ///< index of the left child in `Tree::nodes`, kNone in a leaf
  std::uint32_t right = kNone;
  std::uint32_t first = 0;   ///< first of the node's entries in `Tree::primitives`
  std::uint32_t count = 0;   ///< triangles below; 0 only in "no triangle" nodes (EmptySide::chain)
  std::uint32_t depth = 0;   ///< 0 at the root
  bool undividable = false;  ///< the rule left one side empty here

  [[nodiscard]] bool is_leaf() const { return left == kNone; }

  [[nodiscard]] bool operator==(const Node&) const = default;
};

/// A binary tree over the triangles of a mesh. Nodes are in depth-first order, left before right,
/// the root first; an empty mesh has no node. `primitives` is a permutation of the triangle
/// numbers; each node's are the contiguous run [first, first + count).
struct Tree {
  std::vector<Node> nodes;
  std::vector<TriangleId> primitives;

  [[nodiscard]] bool operator==(const Tree&) const = default;

  [[nodiscard]] std::span<const TriangleId> triangles_of(const Node& node) const {
    return std::span(primitives).subspan(node.first, node.count);
  }
};

/// The node with this TreeId, or nullptr where the tree has none. O(depth).
[[nodiscard]] const Node* find_node(const Tree& tree, TreeId id);

/// FNV-1a 64 over all nodes and primitives: equal for equal trees on every machine; -0
/// counts as 0.
[[nodiscard]] std::uint64_t tree_hash(const Tree& tree);

}  // namespace soms
