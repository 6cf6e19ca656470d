/// \file
/// Which nodes of a binary tree become which wide ones.
#pragma once

#include "soms/tree/layout/detail/parts.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace soms::layout {

/// A lane of a wide node: its blocks lie side by side.
struct LanePlan {
  static constexpr std::uint32_t kLeaf = Node::kNone;

  std::uint32_t box = 0;        ///< number of its box
  std::uint32_t child = kLeaf;  ///< number of the wide node below, or kLeaf
  std::uint32_t first_block = 0;
  std::uint32_t end_block = 0;
  std::uint32_t triangles = 0;

  [[nodiscard]] bool is_leaf() const { return child == kLeaf; }
};

/// What one wide node is made of.
struct WidePlan {
  std::uint32_t box = 0;  ///< number of the box of all
  std::uint32_t triangles = 0;
  std::uint32_t count = 0;  ///< lanes
  std::array<LanePlan, WideNode::kWidth> lanes = {};

  [[nodiscard]] std::span<const LanePlan> used() const { return std::span(lanes).first(count); }
};

/// Descends the slot of greatest area, of those that `descends` allows, until there are four.
/// `children` gives both slots below one.
template <class Slot, class Descends, class Bounds, class Children>
std::uint32_t gather(std::array<Slot, WideNode::kWidth>& slots, const Descends& descends,
                     const Bounds& bounds, const Children& children) {
  std::array<double, WideNode::kWidth> area = {};
  const auto look = [&](std::uint32_t k) {
    area[k] = descends(slots[k]) ? half_area(bounds(slots[k])) : -1;
  };
  std::uint32_t count = 1;
  look(0);
  while (count < WideNode::kWidth) {
    const auto best = static_cast<std::uint32_t>(
        std::max_element(area.begin(), area.begin() + count) - area.begin());
    if (!(area[best] >= 0)) {
      break;
    }
    const auto [left, right] = children(slots[best]);
    slots[best] = left;
    slots[count] = right;
    look(best);
    look(count);
    ++count;
  }
  return count;
}

/// The wide nodes of a part, parents before children; none if it is one leaf and not `alone`, the
/// whole tree, which needs a node. `boxes` are those of the part's nodes, `first_block` tells how
/// many blocks lie before each, and at its end how many there are.
[[nodiscard]] std::vector<WidePlan> plan_part(std::span<const PartNode> part,
                                              std::span<const Box> boxes,
                                              std::span<const std::uint32_t> first_block,
                                              bool alone);

}  // namespace soms::layout
