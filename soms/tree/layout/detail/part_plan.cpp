#include "soms/tree/layout/detail/part_plan.h"

namespace soms::layout {

namespace {

/// A node of a part, and the first one that is not below it.
struct PartSlot {
  std::uint32_t node = 0;
  std::uint32_t end = 0;
};

PartSlot left_of(std::span<const PartNode> part, const PartSlot& slot) {
  return {slot.node + 1, part[slot.node].right};
}

PartSlot right_of(std::span<const PartNode> part, const PartSlot& slot) {
  return {part[slot.node].right, slot.end};
}

/// Nodes with one child that holds triangles are passed over.
PartSlot without_empty(std::span<const PartNode> part, PartSlot slot) {
  while (!part[slot.node].is_leaf()) {
    const PartSlot left = left_of(part, slot);
    const PartSlot right = right_of(part, slot);
    if (part[left.node].count == 0) {
      slot = right;
    } else if (part[right.node].count == 0) {
      slot = left;
    } else {
      break;
    }
  }
  return slot;
}

}  // namespace

std::vector<WidePlan> plan_part(std::span<const PartNode> part, std::span<const Box> boxes,
                                std::span<const std::uint32_t> first_block, bool alone) {
  std::vector<WidePlan> plan;
  const PartSlot root = without_empty(part, {0, static_cast<std::uint32_t>(part.size())});
  if (part[root.node].is_leaf() && !alone) {
    return plan;
  }
  std::vector<std::pair<PartSlot, std::uint32_t>> pending{{root, 0}};
  plan.emplace_back();
  while (!pending.empty()) {
    const auto [slot, at] = pending.back();
    pending.pop_back();
    std::array<PartSlot, WideNode::kWidth> slots{slot};
    WidePlan wide;
    wide.box = slot.node;
    wide.triangles = part[slot.node].count;
    wide.count = gather(
        slots, [&](const PartSlot& s) { return !part[s.node].is_leaf(); },
        [&](const PartSlot& s) -> const Box& { return boxes[s.node]; },
        [&](const PartSlot& s) {
          return std::pair{without_empty(part, left_of(part, s)),
                           without_empty(part, right_of(part, s))};
        });
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      LanePlan& lane = wide.lanes[k];
      lane.box = slots[k].node;
      lane.first_block = first_block[slots[k].node];
      lane.end_block = first_block[slots[k].end];
      lane.triangles = part[slots[k].node].count;
      if (!part[slots[k].node].is_leaf()) {
        lane.child = static_cast<std::uint32_t>(plan.size());
        pending.emplace_back(slots[k], lane.child);
        plan.emplace_back();
      }
    }
    plan[at] = wide;
  }
  return plan;
}

}  // namespace soms::layout
