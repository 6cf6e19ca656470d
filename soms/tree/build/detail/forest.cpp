#include "soms/tree/build/detail/forest.h"

#include "soms/tree/layout/detail/fetch.h"

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
  layout::fetch_corners(mesh, ids.subspan(subtree.front().first, subtree.front().count));
  // Children follow their parents, so the last node comes first.
  for (std::size_t i = subtree.size(); i-- > 0;) {
    Node& node = subtree[i];
    if (node.is_leaf()) {
      bound_leaf(node, mesh, ids);
    } else {
      node.bounds = subtree[node.left].bounds;
      node.bounds.grow(subtree[node.right].bounds);
    }
  }
}

void finish(Forest& forest, const Mesh& mesh, const Parallel& parallel) {
  for_each_chunk(forest.subtrees.size(), 1, parallel, [&](std::size_t k, std::size_t) {
    find_bounds(forest.subtrees[k], mesh, forest.ids);
  });
  for (std::size_t i = forest.upper.size(); i-- > 0;) {
    Upper& upper = forest.upper[i];
    if (upper.subtree != Node::kNone) {
      upper.node.bounds = forest.subtrees[upper.subtree].front().bounds;
    } else {
      upper.node.bounds = forest.upper[upper.node.left].node.bounds;
      upper.node.bounds.grow(forest.upper[upper.node.right].node.bounds);
    }
  }
}

Tree join(Forest forest, const Parallel& parallel) {
  Tree tree;
  std::vector<std::uint32_t> place(forest.upper.size());
  std::uint32_t size = 0;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t i = open.back();
    const Upper& upper = forest.upper[i];
    open.pop_back();
    place[i] = size;
    if (upper.subtree != Node::kNone) {
      size += static_cast<std::uint32_t>(forest.subtrees[upper.subtree].size());
    } else {
      ++size;
      open.push_back(upper.node.right);
      open.push_back(upper.node.left);
    }
  }
  tree.nodes.resize(size);
  for_each_chunk(forest.upper.size(), 64, Parallel{parallel.threads, parallel.stop, {}},
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const Upper& upper = forest.upper[i];
                     if (upper.subtree != Node::kNone) {
                       copy(forest.subtrees[upper.subtree], place[i], tree);
                       continue;
                     }
                     Node& node = tree.nodes[place[i]];
                     node = upper.node;
                     node.left = place[node.left];
                     node.right = place[node.right];
                   }
                 });
  tree.primitives = std::move(forest.ids);
  return tree;
}

layout::Parts parts_of(Forest& forest, const Mesh& mesh) {
  layout::Parts result;
  result.bounds = forest.bounds;
  result.prepare = [&forest, &mesh](std::size_t part) {
    find_bounds(forest.subtrees[part], mesh, forest.ids);
  };
  result.primitives = forest.ids;
  result.upper.reserve(forest.upper.size());
  for (const Upper& upper : forest.upper) {
    const Node& node = upper.node;
    result.upper.push_back({{}, node.count, node.left, node.right, upper.subtree});
  }
  result.parts.reserve(forest.subtrees.size());
  for (const std::vector<Node>& subtree : forest.subtrees) {
    result.parts.push_back({subtree, 0});
  }
  return result;
}

}  // namespace soms::detail
