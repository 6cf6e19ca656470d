#include "soms/tree/check.h"

#include "soms/base/arithmetic.h"
#include "soms/geometry/detail/counts.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace soms {

namespace {

std::string node_name(const Tree& tree, const Node& node) {
  return "node " + std::to_string(&node - tree.nodes.data());
}

std::string fault_of_run(const Tree& tree, const MeshView& mesh, const Node& node) {
  if (std::uint64_t{node.first} + node.count > tree.primitives.size()) {
    return node_name(tree, node) + " has a run beyond the primitives";
  }
  if (!node.is_leaf()) {
    return {};
  }
  Box box;
  for (const TriangleId id : tree.triangles_of(node)) {
    if (id >= mesh.triangles.size()) {
      return node_name(tree, node) + " names " +
             index_fault("triangle " + std::to_string(id), "triangles", mesh.triangles.size());
    }
    box.grow(bounds(mesh.triangle(id)));
  }
  return box == node.bounds ? std::string()
                            : node_name(tree, node) + " has another box than its triangles";
}

std::string fault_of_children(const Tree& tree, const Node& node, const Node& left,
                              const Node& right) {
  if (left.first != node.first || right.first != node.first + left.count ||
      std::uint64_t{left.count} + right.count != node.count) {
    return node_name(tree, node) + " has a run that its children's do not make up";
  }
  if (left.depth != node.depth + 1 || right.depth != node.depth + 1) {
    return node_name(tree, node) + " has a child of another depth than its own plus 1";
  }
  if (left.id != left_child_of(node.id) || right.id != right_child_of(node.id)) {
    return node_name(tree, node) + " has a child whose id is not 2i+1 and 2i+2";
  }
  Box box = left.bounds;
  box.grow(right.bounds);
  return box == node.bounds ? std::string()
                            : node_name(tree, node) + " has another box than its children";
}

/// Traverses the tree depth-first; `tree.nodes` must be met in exactly this order.
std::string fault_of_nodes(const Tree& tree, const MeshView& mesh) {
  std::vector<std::uint32_t> pending{0};
  std::size_t next = 0;
  while (!pending.empty()) {
    const std::uint32_t i = pending.back();
    pending.pop_back();
    if (i != next || i >= tree.nodes.size()) {
      return "node " + std::to_string(next) + " is not the next one in depth-first order";
    }
    ++next;
    const Node& node = tree.nodes[i];
    if (std::string fault = fault_of_run(tree, mesh, node); !fault.empty()) {
      return fault;
    }
    if (node.is_leaf()) {
      if (node.right != Node::kNone) {
        return node_name(tree, node) + " has a right child and no left one";
      }
      continue;
    }
    if (node.left >= tree.nodes.size() || node.right >= tree.nodes.size()) {
      return node_name(tree, node) + " has a child beyond the nodes";
    }
    const Node& left = tree.nodes[node.left];
    const Node& right = tree.nodes[node.right];
    if (std::string fault = fault_of_children(tree, node, left, right); !fault.empty()) {
      return fault;
    }
    pending.push_back(node.right);
    pending.push_back(node.left);
  }
  return next == tree.nodes.size() ? std::string()
                                   : "node " + std::to_string(next) + " has no parent";
}

}  // namespace

std::string find_fault(const Tree& tree, const MeshView& mesh) {
  const PlainArithmetic plain;
  const std::size_t count = mesh.triangles.size();
  if (tree.primitives.size() != count) {
    return std::to_string(tree.primitives.size()) + " primitives for " + std::to_string(count) +
           " triangles";
  }
  if (count == 0) {
    return tree.nodes.empty() ? "" : "an empty mesh has a tree with nodes";
  }
  if (tree.nodes.empty()) {
    return "a mesh with triangles has a tree without nodes";
  }
  const Node& root = tree.nodes[0];
  if (root.id != 0 || root.depth != 0 || root.first != 0 || root.count != count) {
    return "node 0 is not a root that holds all triangles";
  }
  std::vector<bool> seen(count);
  for (const TriangleId id : tree.primitives) {
    if (id >= count || seen[id]) {
      return "the primitives are no permutation: " + std::to_string(id);
    }
    seen[id] = true;
  }
  return fault_of_nodes(tree, mesh);
}

}  // namespace soms
