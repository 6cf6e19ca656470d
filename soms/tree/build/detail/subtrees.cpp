#include "soms/tree/build/detail/subtrees.h"

#include "soms/tree/layout/detail/fetch_corners.h"

#include <algorithm>

namespace soms::detail {

namespace {

void bound_leaf(Node& leaf, const Mesh& mesh, std::span<TriangleId> ids) {
  const auto run = ids.subspan(leaf.first, leaf.count);
  if (!std::is_sorted(run.begin(), run.end())) {
    std::sort(run.begin(), run.end());
  }
  for (const TriangleId id : run) {
    leaf.bounds.grow(bounds(mesh.triangle(id)));
  }
}

void copy(std::vector<Node>& subtree, std::uint32_t at, Tree& tree) {
  for (std::size_t k = 0; k < subtree.size(); ++k) {
    Node& node = tree.nodes[at + k];
    node = subtree[k];
    if (!node.is_leaf()) {
      node.left += at;
      node.right += at;
    }
  }
  subtree = {};
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

Parallel within(const Parallel& parallel, double from, double to) {
  Parallel part{parallel.threads, parallel.stop, {}};
  if (parallel.progress) {
    part.progress = [&parallel, from, to](double share) {
      parallel.progress(from + (to - from) * share);
    };
  }
  return part;
}

void find_bounds(std::span<Node> subtree, const Mesh& mesh, std::span<TriangleId> ids) {
  const Node& root = subtree.front();
  layout::FetchBackwards fetch(mesh, ids.subspan(root.first, root.count));
  // Children follow their parents, so the last node comes first.
  for (std::size_t i = subtree.size(); i-- > 0;) {
    Node& node = subtree[i];
    if (node.is_leaf()) {
      fetch.reach(node.first - root.first);
      bound_leaf(node, mesh, ids);
    } else {
      node.bounds = subtree[node.left].bounds;
      node.bounds.grow(subtree[node.right].bounds);
    }
  }
}

void finish(Subtrees& subtrees, const Mesh& mesh, const Parallel& parallel) {
  for_each_chunk(subtrees.nodes.size(), 1, parallel, [&](std::size_t k, std::size_t) {
    find_bounds(subtrees.nodes[k], mesh, subtrees.ids);
  });
  for (std::size_t i = subtrees.upper.size(); i-- > 0;) {
    Upper& upper = subtrees.upper[i];
    if (upper.subtree != Node::kNone) {
      upper.node.bounds = subtrees.nodes[upper.subtree].front().bounds;
    } else {
      upper.node.bounds = subtrees.upper[upper.node.left].node.bounds;
      upper.node.bounds.grow(subtrees.upper[upper.node.right].node.bounds);
    }
  }
}

Tree join(Subtrees subtrees, const Parallel& parallel) {
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
  for_each_chunk(subtrees.upper.size(), 64, Parallel{parallel.threads, parallel.stop, {}},
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const Upper& upper = subtrees.upper[i];
                     if (upper.subtree != Node::kNone) {
                       copy(subtrees.nodes[upper.subtree], place[i], tree);
                       continue;
                     }
                     Node& node = tree.nodes[place[i]];
                     node = upper.node;
                     node.left = place[node.left];
                     node.right = place[node.right];
                   }
                 });
  tree.primitives = std::move(subtrees.ids);
  return tree;
}

layout::Parts parts_of(Subtrees& subtrees, const Mesh& mesh) {
  layout::Parts result;
  result.bounds = subtrees.bounds;
  result.prepare = [&subtrees, &mesh](std::size_t part) {
    find_bounds(subtrees.nodes[part], mesh, subtrees.ids);
  };
  result.primitives = subtrees.ids;
  result.upper.reserve(subtrees.upper.size());
  for (const Upper& upper : subtrees.upper) {
    const Node& node = upper.node;
    result.upper.push_back({{}, node.count, node.left, node.right, upper.subtree});
  }
  result.parts.reserve(subtrees.nodes.size());
  for (const std::vector<Node>& subtree : subtrees.nodes) {
    result.parts.push_back({subtree, 0});
  }
  return result;
}

}  // namespace soms::detail
