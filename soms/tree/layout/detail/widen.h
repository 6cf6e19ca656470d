/// \file
/// From binary nodes to wide ones, part by part.
#pragma once

#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/frame.h"
#include "soms/tree/layout/wide_tree.h"

#include <functional>
#include <span>
#include <vector>

namespace soms::layout {

/// A node with more triangles than this is laid out before all others; those below it begin a part,
/// which one thread lays out. A constant, so that the layout cannot depend on the threads.
inline constexpr std::uint32_t kPartTriangles = 8192;

/// A node above the parts, or the place of a part.
struct UpperNode {
  Box bounds = {};  ///< found when the tree is laid out
  std::uint32_t count = 0;
  std::uint32_t left = Node::kNone;  ///< in the same array
  std::uint32_t right = Node::kNone;
  std::uint32_t part = Node::kNone;  ///< number of the part that begins here
};

/// The nodes of a part, its root first; children count from `first`.
struct Part {
  std::span<const Node> nodes;
  std::uint32_t first = 0;

  [[nodiscard]] const Node& left_of(const Node& node) const { return nodes[node.left - first]; }

  [[nodiscard]] const Node& right_of(const Node& node) const { return nodes[node.right - first]; }
};

/// A canonical tree in parts: node 0 of `upper` is the root, and children follow their parents. A
/// part begins at each node of at most kPartTriangles, or without children, below none such.
struct Parts {
  Box bounds;  ///< of the mesh
  std::vector<UpperNode> upper;
  std::vector<Part> parts;
  std::span<const TriangleId> primitives;
  /// Called with a part's number before its boxes and its leaves' order are looked at: builders
  /// leave both to be found while the part's corners are at hand. May be empty.
  std::function<void(std::size_t)> prepare;
};

/// The same tree in parts, without copying its nodes.
[[nodiscard]] Parts parts_of(const Tree& tree);

/// Lays a tree with at least one triangle out; parts lie in the tree's order. The same bytes for
/// any numbering of upper nodes and parts, and any number of threads. \errors
/// ErrorKind::out_of_range beyond 2^28 nodes or blocks; cancelled.
void widen(Parts tree, const Mesh& mesh, const Frame& frame, const Parallel& parallel,
           Pages<WideNode>& nodes, Pages<TriangleBlock>& blocks);

}  // namespace soms::layout
