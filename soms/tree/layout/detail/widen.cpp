#include "soms/tree/layout/detail/widen.h"

#include "soms/base/error.h"
#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/lay_out.h"
#include "soms/tree/layout/detail/node_boxes.h"

#include <limits>

namespace soms::layout {

namespace {

/// Upper nodes with one child that holds triangles are passed over.
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

/// A wide node above the parts.
struct UpperWide {
  std::uint32_t binary;
  std::uint32_t count;
  std::array<std::uint32_t, WideNode::kWidth> slots;
  std::array<std::uint32_t, WideNode::kWidth> child;  ///< of slots that begin no part
};

/// Which upper nodes become which wide ones; none where all is one part.
std::vector<UpperWide> plan_upper(const std::vector<UpperNode>& upper,
                                  const std::vector<Box>& boxes) {
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
        [&](std::uint32_t i) -> const Box& { return boxes[i]; },
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

std::uint32_t blocks_of(std::span<const PartNode> part) {
  std::uint32_t blocks = 0;
  for (const PartNode& node : part) {
    blocks += node.is_leaf() ? blocks_for(node.count) : 0;
  }
  return blocks;
}

std::uint32_t checked(std::uint64_t count) {
  if (count >= WideNode::kMost) {
    throw Error(ErrorKind::out_of_range, "the layout has 2^28 nodes or blocks",
                "allow more triangles per leaf");
  }
  return static_cast<std::uint32_t>(count);
}

/// What became of a part. Its nodes wait beside: how many there are is known only with the boxes.
struct LaidPart {
  Box bounds;
  std::uint32_t block_base = 0;
  std::uint32_t blocks = 0;
  std::uint32_t node_base = 0;
  std::uint32_t node_count = 0;  ///< 0 if the part is one leaf
  Pages<WideNode> nodes;
  Pages<TriangleId> least_ids;
  TriangleId least = 0;  ///< of all
};

class Widen {
 public:
  Widen(const Parts& tree, const MeshView& mesh, const Frame& frame, const Limits& limits)
      : tree_(tree),
        mesh_(mesh),
        frame_(frame),
        limits_(limits),
        order_(order_of(tree.upper)),
        parts_(tree.nodes.size()) {}

  Laid run() {
    place_blocks();
    const bool alone = tree_.upper[without_empty(tree_.upper, 0)].part != Node::kNone;
    for_each_chunk(order_.size(), 1, limits_,
                   [&](std::size_t k, std::size_t) { lay_out(order_[k], alone); });
    find_bounds();
    const std::vector<UpperWide> upper = plan_upper(tree_.upper, boxes_);
    place_nodes(upper.size());
    for_each_chunk(order_.size(), 1, {.threads = limits_.threads, .stop = limits_.stop},
                   [&](std::size_t k, std::size_t) { move(parts_[order_[k]]); });
    for (std::size_t k = upper.size(); k-- > 0;) {
      write_upper(upper[k], k);
    }
    return std::move(laid_);
  }

 private:
  void place_blocks() {
    std::uint64_t count = 0;
    for (const std::uint32_t k : order_) {
      parts_[k].block_base = static_cast<std::uint32_t>(count);
      parts_[k].blocks = blocks_of(tree_.nodes[k]);
      count += parts_[k].blocks;
      static_cast<void>(checked(count));
    }
    laid_.blocks.resize(count);
  }

  void lay_out(std::uint32_t k, bool alone) {
    LaidPart& part = parts_[k];
    const auto blocks = std::span(laid_.blocks).subspan(part.block_base, part.blocks);
    const PartContent content =
        write_blocks(tree_.nodes[k], tree_.primitives, mesh_, frame_, blocks);
    const std::vector<WidePlan> plan =
        plan_part(tree_.nodes[k], content.boxes, content.first_block, alone);
    part.bounds = content.boxes.front();
    part.node_count = static_cast<std::uint32_t>(plan.size());
    part.nodes.resize(plan.size());
    part.least_ids.resize(plan.size());
    write_nodes({plan, content.boxes, content.moments, blocks, 0, part.block_base}, frame_,
                part.nodes, part.least_ids);
    part.least = plan.empty() ? least_id(blocks) : part.least_ids.front();
  }

  /// Bounds of the upper nodes from those of the parts.
  void find_bounds() {
    boxes_.resize(tree_.upper.size());
    for (std::size_t i = boxes_.size(); i-- > 0;) {
      const UpperNode& node = tree_.upper[i];
      if (node.part != Node::kNone) {
        boxes_[i] = parts_[node.part].bounds;
      } else {
        boxes_[i] = boxes_[node.left];
        boxes_[i].grow(boxes_[node.right]);
      }
    }
  }

  void place_nodes(std::uint64_t upper) {
    std::uint64_t count = upper;
    for (const std::uint32_t k : order_) {
      parts_[k].node_base = static_cast<std::uint32_t>(count);
      count += parts_[k].node_count;
      static_cast<void>(checked(count));
    }
    laid_.nodes.resize(count);
    laid_.least_ids.resize(count);
  }

  /// Moves a part's nodes to their place, from which they count.
  void move(LaidPart& part) {
    WideNode* to = laid_.nodes.data() + part.node_base;
    for (WideNode& node : part.nodes) {
      for (std::size_t k = 0; k < node.count; ++k) {
        node.child[k] += (std::uint32_t{node.leaves} >> k & 1U) != 0 ? 0 : part.node_base;
      }
      *to++ = node;
    }
    std::copy(part.least_ids.begin(), part.least_ids.end(),
              laid_.least_ids.begin() + part.node_base);
    part.nodes = {};
    part.least_ids = {};
  }

  /// Lanes of an upper node: boxes along the mesh's axes, and what lies in them.
  void write_upper(const UpperWide& wide, std::size_t place) {
    WideNode node;
    TriangleId least = std::numeric_limits<TriangleId>::max();
    node.count = static_cast<std::uint8_t>(wide.count);
    node.origin = frame_.middle(boxes_[wide.binary]);
    std::array<LaneContent, WideNode::kWidth> content;
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      const UpperNode& below = tree_.upper[wide.slots[k]];
      content[k].bounds = boxes_[wide.slots[k]];
      if (below.part == Node::kNone) {
        node.child[k] = wide.child[k];
        least = std::min(least, laid_.least_ids[wide.child[k]]);
        continue;
      }
      const LaidPart& part = parts_[below.part];
      least = std::min(least, part.least);
      if (part.node_count == 0) {
        set_leaf(node, k, part.block_base, below.count);
      } else {
        node.child[k] = part.node_base;
      }
    }
    set_boxes(std::span(content).first(wide.count), kMeshAxes, frame_, node);
    laid_.nodes[place] = node;
    laid_.least_ids[place] = least;
  }

  const Parts& tree_;
  MeshView mesh_;
  const Frame& frame_;
  const Limits& limits_;
  std::vector<std::uint32_t> order_;
  std::vector<LaidPart> parts_;
  std::vector<Box> boxes_;  ///< of the upper nodes
  Laid laid_;
};

}  // namespace

Laid widen(const Parts& tree, const MeshView& mesh, const Frame& frame, const Limits& limits) {
  return Widen(tree, mesh, frame, limits).run();
}

}  // namespace soms::layout
