#include "soms/tree/build/detail/subtrees.h"

#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/fetch_corners.h"

#include <algorithm>
#include <array>
#include <limits>

namespace soms::detail {

namespace {

/// A subtree written out: its root's number and depth are there, boxes are found.
void write_out(const Node& root, std::span<const PartNode> subtree, const MeshView& mesh,
               std::span<const TriangleId> ids, std::uint32_t at, std::span<Node> nodes) {
  nodes.front() = root;
  layout::fetch_corners(mesh, ids.subspan(root.first, root.count));
  for (std::uint32_t i = 0; i < subtree.size(); ++i) {
    const PartNode& from = subtree[i];
    Node& node = nodes[i];
    node.undividable = from.undividable;
    if (!from.is_leaf()) {
      const PartNode& left = subtree[i + 1];
      const PartNode& right = subtree[from.right];
      nodes[i + 1] = child_of(node, false, left.first, left.count);
      nodes[from.right] = child_of(node, true, right.first, right.count);
      node.left = at + i + 1;
      node.right = at + from.right;
    }
  }
  // Children follow their parents, so the last node comes first.
  for (std::size_t i = subtree.size(); i-- > 0;) {
    Node& node = nodes[i];
    if (node.is_leaf()) {
      for (const TriangleId id : ids.subspan(node.first, node.count)) {
        node.bounds.grow(bounds(mesh.triangle(id)));
      }
    } else {
      node.bounds = nodes[i + 1].bounds;
      node.bounds.grow(nodes[subtree[i].right].bounds);
    }
  }
}

constexpr std::size_t kFew = 8;

/// Ids in ascending order, of which there are at most kFew, by a network of comparisons: the same
/// steps for all, so that no branch depends on them. \source Knuth 1998, section 5.3.4.
void sort_few(std::span<TriangleId> ids) {
  constexpr std::array<std::uint8_t, 19> kLow = {0, 1, 4, 5, 0, 1, 2, 3, 0, 2,
                                                 4, 6, 2, 3, 1, 3, 1, 3, 5};
  constexpr std::array<std::uint8_t, 19> kHigh = {2, 3, 6, 7, 4, 5, 6, 7, 1, 3,
                                                  5, 7, 4, 5, 4, 6, 2, 4, 6};
  std::array<TriangleId, kFew> sorted;
  for (std::size_t k = 0; k < kFew; ++k) {
    sorted[k] = k < ids.size() ? ids[k] : std::numeric_limits<TriangleId>::max();
  }
#pragma GCC unroll 19
  for (std::size_t k = 0; k < kLow.size(); ++k) {
    const TriangleId a = sorted[kLow[k]];
    const TriangleId b = sorted[kHigh[k]];
    sorted[kLow[k]] = a < b ? a : b;
    sorted[kHigh[k]] = a < b ? b : a;
  }
  std::copy_n(sorted.begin(), ids.size(), ids.begin());
}

}  // namespace

Node child_of(const Node& parent, bool right, std::uint32_t first, std::uint32_t count) {
  Node node;
  node.id = right ? right_child_of(parent.id) : left_child_of(parent.id);
  node.first = first;
  node.count = count;
  node.depth = parent.depth + 1;
  return node;
}

Limits within(const Limits& limits, double from, double to) {
  Limits part = limits.silent();
  if (limits.progress) {
    part.progress = [&limits, from, to](double share) {
      limits.progress(from + (to - from) * share);
    };
  }
  return part;
}

void order_leaves(std::span<const PartNode> subtree, std::span<TriangleId> ids) {
  for (const PartNode& node : subtree) {
    if (node.is_leaf()) {
      const auto run = ids.subspan(node.first, node.count);
      if (run.size() <= kFew) {
        sort_few(run);
      } else {
        std::sort(run.begin(), run.end());
      }
    }
  }
}

Tree join(Subtrees subtrees, const MeshView& mesh, const Limits& limits) {
  Tree tree;
  std::vector<std::uint32_t> place(subtrees.upper.size());
  std::uint32_t size = 0;
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    const Upper& upper = subtrees.upper[i];
    pending.pop_back();
    place[i] = size;
    if (upper.subtree != Node::kNone) {
      size += static_cast<std::uint32_t>(subtrees.nodes[upper.subtree].size());
    } else {
      ++size;
      pending.push_back(upper.node.right);
      pending.push_back(upper.node.left);
    }
  }
  tree.nodes.resize(size);
  for_each_chunk(subtrees.upper.size(), 1, limits, [&](std::size_t i, std::size_t) {
    const Upper& upper = subtrees.upper[i];
    if (upper.subtree != Node::kNone) {
      std::vector<PartNode>& nodes = subtrees.nodes[upper.subtree];
      write_out(upper.node, nodes, mesh, subtrees.ids, place[i],
                std::span(tree.nodes).subspan(place[i], nodes.size()));
      nodes = {};
    }
  });
  // Children follow their parents among the upper nodes, too.
  for (std::size_t i = subtrees.upper.size(); i-- > 0;) {
    const Upper& upper = subtrees.upper[i];
    if (upper.subtree == Node::kNone) {
      Node& node = tree.nodes[place[i]];
      node = upper.node;
      node.left = place[upper.node.left];
      node.right = place[upper.node.right];
      node.bounds = tree.nodes[node.left].bounds;
      node.bounds.grow(tree.nodes[node.right].bounds);
    }
  }
  tree.primitives = std::move(subtrees.ids);
  return tree;
}

layout::Parts parts_of(Subtrees& subtrees) {
  layout::Parts result;
  result.bounds = subtrees.bounds;
  result.primitives = subtrees.ids;
  result.upper.reserve(subtrees.upper.size());
  for (const Upper& upper : subtrees.upper) {
    const Node& node = upper.node;
    result.upper.push_back({node.count, node.left, node.right, upper.subtree});
  }
  result.nodes = std::move(subtrees.nodes);
  return result;
}

}  // namespace soms::detail
