#include "soms/tree/layout/detail/widen.h"

#include "soms/base/error.h"
#include "soms/tree/layout/detail/fetch_corners.h"
#include "soms/tree/layout/detail/lay_out.h"

namespace soms::layout {

namespace {

using Slots = std::array<std::uint32_t, WideNode::kWidth>;

/// Descends the node of greatest area, of those that `descends` allows, until there are four.
/// `children` gives both places below one.
template <class Descends, class Bounds, class Children>
std::uint32_t gather(Slots& slots, const Descends& descends, const Bounds& bounds,
                     const Children& children) {
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

/// Nodes with one child that holds triangles are passed over.
std::uint32_t without_empty(const Part& part, std::uint32_t i) {
  while (!part.nodes[i].is_leaf()) {
    const Node& node = part.nodes[i];
    if (part.left_of(node).count == 0) {
      i = node.right - part.first;
    } else if (part.right_of(node).count == 0) {
      i = node.left - part.first;
    } else {
      break;
    }
  }
  return i;
}

std::uint32_t without_empty(const std::vector<UpperNode>& upper, std::uint32_t i) {
  while (upper[i].part == Node::kNone) {
    if (upper[upper[i].left].count == 0) {
      i = upper[i].right;
    } else if (upper[upper[i].right].count == 0) {
      i = upper[i].left;
    } else {
      break;
    }
  }
  return i;
}

/// Children follow their parents, so the last node comes first.
void find_block_ends(const Part& part, PartPlan& plan) {
  for (std::size_t i = plan.nodes.size(); i-- > 0;) {
    WidePlan& wide = plan.nodes[i];
    wide.end_block = wide.first_block;
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      const Node& below = part.nodes[wide.slots[k]];
      const std::uint32_t end = below.is_leaf() ? wide.child[k] + blocks_for(below.count)
                                                : plan.nodes[wide.child[k]].end_block;
      wide.end_block = std::max(wide.end_block, end);
    }
  }
}

/// Which nodes of a part become which wide ones. `alone`: it is the whole tree, and needs a node.
void plan_part(const Part& part, bool alone, PartPlan& plan) {
  plan.root = without_empty(part, 0);
  const Node& root = part.nodes[plan.root];
  if (root.is_leaf() && !alone) {
    plan.blocks = blocks_for(root.count);
    return;
  }
  std::vector<std::uint32_t> pending{0};
  plan.nodes.push_back({plan.root, 0, {}, {}, 0, 0});
  while (!pending.empty()) {
    const std::uint32_t at = pending.back();
    pending.pop_back();
    WidePlan wide = plan.nodes[at];
    Slots slots{wide.binary};
    wide.count = gather(
        slots, [&](std::uint32_t i) { return !part.nodes[i].is_leaf(); },
        [&](std::uint32_t i) -> const Box& { return part.nodes[i].bounds; },
        [&](std::uint32_t i) {
          const Node& node = part.nodes[i];
          return std::pair{without_empty(part, node.left - part.first),
                           without_empty(part, node.right - part.first)};
        });
    wide.slots = slots;
    wide.first_block = plan.blocks;
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      const Node& below = part.nodes[slots[k]];
      if (below.is_leaf()) {
        wide.child[k] = plan.blocks;
        plan.blocks += blocks_for(below.count);
      } else {
        wide.child[k] = static_cast<std::uint32_t>(plan.nodes.size());
        pending.push_back(wide.child[k]);
        plan.nodes.push_back({slots[k], 0, {}, {}, 0, 0});
      }
    }
    plan.nodes[at] = wide;
  }
  find_block_ends(part, plan);
}

/// A wide node above the parts.
struct UpperWide {
  std::uint32_t binary;
  std::uint32_t count;
  Slots slots;
  Slots child;  ///< of slots that begin no part
};

/// Parts that hold triangles, from left to right.
std::vector<std::uint32_t> order_of(const std::vector<UpperNode>& upper) {
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const UpperNode& node = upper[pending.back()];
    pending.pop_back();
    if (node.part == Node::kNone) {
      pending.push_back(node.right);
      pending.push_back(node.left);
    } else if (node.count > 0) {
      order.push_back(node.part);
    }
  }
  return order;
}

/// Bounds of the upper nodes from those of the parts.
void find_bounds(Parts& tree) {
  for (std::size_t i = tree.upper.size(); i-- > 0;) {
    UpperNode& node = tree.upper[i];
    if (node.part != Node::kNone) {
      node.bounds = tree.parts[node.part].nodes.front().bounds;
    } else {
      node.bounds = tree.upper[node.left].bounds;
      node.bounds.grow(tree.upper[node.right].bounds);
    }
  }
}

/// Which upper nodes become which wide ones; none where all is one part.
std::vector<UpperWide> plan_upper(const std::vector<UpperNode>& upper) {
  std::vector<UpperWide> plan;
  const std::uint32_t root = without_empty(upper, 0);
  if (upper[root].part != Node::kNone) {
    return plan;
  }
  std::vector<std::uint32_t> pending{0};
  plan.push_back({root, 0, {}, {}});
  while (!pending.empty()) {
    const std::uint32_t at = pending.back();
    pending.pop_back();
    UpperWide wide = plan[at];
    wide.slots[0] = wide.binary;
    wide.count = gather(
        wide.slots, [&](std::uint32_t i) { return upper[i].part == Node::kNone; },
        [&](std::uint32_t i) -> const Box& { return upper[i].bounds; },
        [&](std::uint32_t i) {
          return std::pair{without_empty(upper, upper[i].left),
                           without_empty(upper, upper[i].right)};
        });
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      const UpperNode& below = upper[wide.slots[k]];
      if (below.part == Node::kNone) {
        wide.child[k] = static_cast<std::uint32_t>(plan.size());
        pending.push_back(wide.child[k]);
        plan.push_back({wide.slots[k], 0, {}, {}});
      }
    }
    plan[at] = wide;
  }
  return plan;
}

/// Lanes of an upper node: boxes along the mesh's axes, and what lies in them.
WideNode upper_node(const UpperWide& wide, const Parts& tree, const std::vector<PartPlan>& plans,
                    const Frame& frame) {
  WideNode node;
  node.count = static_cast<std::uint8_t>(wide.count);
  std::array<Box, WideNode::kWidth> boxes;
  for (std::uint32_t k = 0; k < wide.count; ++k) {
    const UpperNode& below = tree.upper[wide.slots[k]];
    boxes[k] = below.bounds;
    if (below.part == Node::kNone) {
      node.child[k] = wide.child[k];
      continue;
    }
    const PartPlan& plan = plans[below.part];
    const std::uint32_t count = tree.parts[below.part].nodes[plan.root].count;
    if (plan.nodes.empty()) {
      set_leaf(node, k, plan.block_base, count);
    } else {
      node.child[k] = plan.node_base;
    }
  }
  store_upper(tree.upper[wide.binary].bounds, boxes, frame, node);
  return node;
}

std::uint64_t blocks_of(const Part& part) {
  std::uint64_t blocks = 0;
  for (const Node& node : part.nodes) {
    blocks += node.is_leaf() ? blocks_for(node.count) : 0;
  }
  return blocks;
}

void check_count(std::uint64_t count) {
  if (count >= WideNode::kMost) {
    throw Error(ErrorKind::out_of_range, "the layout has 2^28 nodes or blocks",
                "allow more triangles per leaf");
  }
}

/// Brings all corners of the part into the caches, many at a time.
void fetch(const Part& part, std::span<const TriangleId> primitives, const Mesh& mesh) {
  const Node& root = part.nodes.front();
  fetch_corners(mesh, primitives.subspan(root.first, root.count));
}

/// Moves a part's nodes to their place, from which they count.
void move_to(Pages<WideNode>& waiting, std::uint32_t base, WideNode* place) {
  for (WideNode& node : waiting) {
    for (std::size_t k = 0; k < node.count; ++k) {
      node.child[k] += (std::uint32_t{node.leaves} >> k & 1U) != 0 ? 0 : base;
    }
    *place++ = node;
  }
  waiting = {};
}

}  // namespace

Parts parts_of(const Tree& tree) {
  Parts result;
  result.bounds = tree.nodes.front().bounds;
  result.primitives = tree.primitives;
  const std::span<const Node> nodes(tree.nodes);

  struct Pending {
    std::uint32_t binary;
    std::uint32_t upper;
    std::uint32_t end;  // nodes of this one and below lie before it
  };

  std::vector<Pending> pending{{0, 0, static_cast<std::uint32_t>(nodes.size())}};
  result.upper.emplace_back();
  while (!pending.empty()) {
    const Pending next = pending.back();
    pending.pop_back();
    const Node& node = nodes[next.binary];
    UpperNode upper{node.bounds, node.count, Node::kNone, Node::kNone, Node::kNone};
    if (node.count <= kPartTriangles || node.is_leaf()) {
      upper.part = static_cast<std::uint32_t>(result.parts.size());
      result.parts.push_back({nodes.subspan(next.binary, next.end - next.binary), next.binary});
    } else {
      upper.left = static_cast<std::uint32_t>(result.upper.size());
      upper.right = upper.left + 1;
      pending.push_back({node.right, upper.right, next.end});
      pending.push_back({node.left, upper.left, node.right});
      result.upper.resize(result.upper.size() + 2);
    }
    result.upper[next.upper] = upper;
  }
  return result;
}

void widen(Parts tree, const Mesh& mesh, const Frame& frame, const Parallel& parallel,
           Pages<WideNode>& nodes, Pages<TriangleBlock>& blocks) {
  const std::vector<std::uint32_t> order = order_of(tree.upper);
  std::vector<PartPlan> plans(tree.parts.size());
  std::uint64_t count = 0;
  for (const std::uint32_t part : order) {
    plans[part].block_base = static_cast<std::uint32_t>(count);
    count += blocks_of(tree.parts[part]);
    check_count(count);
  }
  blocks.resize(count);
  // Nodes wait beside: how many there are is known only with the boxes.
  std::vector<Pages<WideNode>> waiting(tree.parts.size());
  const bool alone = tree.upper[without_empty(tree.upper, 0)].part != Node::kNone;
  for_each_chunk(order.size(), 1, parallel, [&](std::size_t k, std::size_t) {
    const std::uint32_t part = order[k];
    if (tree.prepare) {
      tree.prepare(part);
    } else {
      fetch(tree.parts[part], tree.primitives, mesh);
    }
    plan_part(tree.parts[part], alone, plans[part]);
    const PartPlan& plan = plans[part];
    waiting[part].resize(plan.nodes.size());
    lay_out(tree.parts[part], plan, tree.primitives, mesh, frame, waiting[part],
            std::span(blocks).subspan(plan.block_base, plan.blocks));
  });
  find_bounds(tree);
  const std::vector<UpperWide> upper = plan_upper(tree.upper);
  count = upper.size();
  for (const std::uint32_t part : order) {
    plans[part].node_base = static_cast<std::uint32_t>(count);
    count += waiting[part].size();
    check_count(count);
  }
  nodes.resize(count);
  for (std::size_t k = 0; k < upper.size(); ++k) {
    nodes[k] = upper_node(upper[k], tree, plans, frame);
  }
  for_each_chunk(order.size(), 1, {parallel.threads, parallel.stop, {}},
                 [&](std::size_t k, std::size_t) {
                   const std::uint32_t base = plans[order[k]].node_base;
                   move_to(waiting[order[k]], base, nodes.data() + base);
                 });
}

}  // namespace soms::layout
