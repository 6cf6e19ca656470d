/// \file
/// The storage of the thesis: one slot for each TreeId, whether the node exists or not.
#pragma once

#include "soms/tree/tree.h"

#include <span>
#include <vector>

namespace soms {

/// A tree in an array of 2^level - 1 slots, indexed by TreeId: no child indices, but memory that
/// doubles with each level. The canonical `Tree` holds the same nodes compactly.
/// \source  thesis, figs. 4.14 to 4.21 and 4.24 to 4.28.
struct ImplicitTree {
  struct Slot {
    Box bounds;
    std::uint32_t first = 0;   ///< first of the node's entries in `primitives`
    std::uint32_t count = 0;   ///< triangles below
    bool used = false;         ///< the node exists
    bool undividable = false;  ///< the rule left one side empty here

    [[nodiscard]] bool operator==(const Slot&) const = default;
  };

  std::vector<Slot> slots;
  std::vector<TriangleId> primitives;

  [[nodiscard]] bool operator==(const ImplicitTree&) const = default;

  /// The slot of a node, or nullptr where the tree has no such node.
  [[nodiscard]] const Slot* find(TreeId id) const {
    return id < slots.size() && slots[id].used ? &slots[id] : nullptr;
  }

  /// True if the node exists and has no children.
  [[nodiscard]] bool is_leaf(TreeId id) const {
    return find(id) != nullptr && find(left_child_of(id)) == nullptr;
  }

  [[nodiscard]] std::span<const TriangleId> triangles_of(const Slot& slot) const {
    return std::span(primitives).subspan(slot.first, slot.count);
  }
};

/// Greatest level of an implicit tree: 2^24 - 1 slots of 64 bytes are 1 GiB.
inline constexpr int kMaxImplicitLevel = 24;

/// The same nodes in 2^level - 1 slots.
///
/// \pre     `tree` is whole (`find_fault`).
/// \errors  ErrorKind::usage unless `level` is 1 to kMaxImplicitLevel and the tree has at most that
///          many levels.
/// \cost    O(2^level) time and memory.
[[nodiscard]] ImplicitTree to_implicit(const Tree& tree, int level);

/// The same nodes in the canonical form; `to_tree(to_implicit(tree, level)) == tree`.
[[nodiscard]] Tree to_tree(const ImplicitTree& tree);

}  // namespace soms
