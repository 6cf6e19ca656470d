#include "soms/thesis/implicit.h"

#include "soms/base/error.h"

#include <algorithm>
#include <string>

namespace soms {

namespace {

int levels_of(const Tree& tree) {
  std::uint32_t levels = 0;
  for (const Node& node : tree.nodes) {
    levels = std::max(levels, node.depth + 1);
  }
  return static_cast<int>(levels);
}

}  // namespace

ImplicitTree to_implicit(const Tree& tree, int level) {
  const int needed = std::max(1, levels_of(tree));
  if (level < needed || level > kMaxImplicitLevel) {
    throw Error(ErrorKind::usage,
                "implicit tree of level " + std::to_string(level) + " for a tree of " +
                    std::to_string(needed) + " levels",
                "use a level from the tree's own to " + std::to_string(kMaxImplicitLevel) +
                    ", or build with a smaller level");
  }
  ImplicitTree result;
  result.slots.resize((std::size_t{1} << static_cast<unsigned>(level)) - 1);
  result.primitives = tree.primitives;
  for (const Node& node : tree.nodes) {
    result.slots[node.id] = {node.bounds, node.first, node.count, true, node.undividable};
  }
  return result;
}

Tree to_tree(const ImplicitTree& tree) {
  Tree result;
  result.primitives = tree.primitives;
  if (tree.find(0) == nullptr) {
    return result;
  }

  struct Pending {
    TreeId id;
    std::uint32_t right_of;  // parent, for right children
  };

  std::vector<Pending> pending{{0, Node::kNone}};
  while (!pending.empty()) {
    const auto [id, right_of] = pending.back();
    pending.pop_back();
    const ImplicitTree::Slot& slot = tree.slots[id];
    const auto i = static_cast<std::uint32_t>(result.nodes.size());
    const bool leaf = tree.is_leaf(id);
    Node& node = result.nodes.emplace_back();
    node = {slot.bounds,
            id,
            leaf ? Node::kNone : i + 1,
            Node::kNone,
            slot.first,
            slot.count,
            static_cast<std::uint32_t>(depth_of(id)),
            slot.undividable};
    if (!leaf) {
      pending.push_back({right_child_of(id), i});
      pending.push_back({left_child_of(id), Node::kNone});
    }
    if (right_of != Node::kNone) {
      result.nodes[right_of].right = i;
    }
  }
  return result;
}

}  // namespace soms
