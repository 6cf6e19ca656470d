#include "soms/tree/tree.h"

#include "soms/base/arithmetic.h"
#include "soms/base/hash.h"

#include <bit>

namespace soms {

namespace {

/// Adding zero makes -0 a +0: boxes that are equal as numbers hash alike.
void add(Fnv1a& hash, const Vec3& v) {
  hash.add(v.x + 0.0);
  hash.add(v.y + 0.0);
  hash.add(v.z + 0.0);
}

}  // namespace

int depth_of(TreeId id) {
  // id + 1 wraps for kNoTreeId alone, which has no depth.
  return static_cast<int>(std::bit_width(id + 1)) - 1;
}

TreeId parent_of(TreeId id) {
  return id == 0 || id == kNoTreeId ? kNoTreeId : (id - 1) / 2;
}

TreeId left_child_of(TreeId id) {
  return depth_of(id) < kMaxTreeIdDepth && id != kNoTreeId ? 2 * id + 1 : kNoTreeId;
}

TreeId right_child_of(TreeId id) {
  return depth_of(id) < kMaxTreeIdDepth && id != kNoTreeId ? 2 * id + 2 : kNoTreeId;
}

const Node* find_node(const Tree& tree, TreeId id) {
  if (tree.nodes.empty() || id == kNoTreeId) {
    return nullptr;
  }
  // Below its leading one, id + 1 spells the way down: 0 is left, 1 is right.
  const Node* node = tree.nodes.data();
  for (int bit = depth_of(id) - 1; bit >= 0; --bit) {
    if (node->is_leaf()) {
      return nullptr;
    }
    const bool right = ((id + 1) >> static_cast<unsigned>(bit) & 1U) != 0;
    node = &tree.nodes[right ? node->right : node->left];
  }
  return node;
}

std::uint64_t tree_hash(const Tree& tree) {
  const PlainArithmetic plain;
  Fnv1a hash;
  for (const Node& node : tree.nodes) {
    add(hash, node.bounds.lower);
    add(hash, node.bounds.upper);
    hash.add(node.id);
    hash.add(node.left);
    hash.add(node.right);
    hash.add(node.first);
    hash.add(node.count);
    hash.add(node.depth);
    hash.add_byte(node.undividable ? 1 : 0);
  }
  for (const TriangleId id : tree.primitives) {
    hash.add(id);
  }
  return hash.value();
}

}  // namespace soms
