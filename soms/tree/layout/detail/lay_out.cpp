#include "soms/tree/layout/detail/lay_out.h"

#include "soms/tree/layout/detail/node_boxes.h"

#include <limits>

namespace soms::layout {

namespace {

/// Larger nodes keep the mesh's axes: what they hold is rarely flat.
constexpr std::uint32_t kMostOriented = 512;

/// Where a node sees a place, in units of the layout.
Vec3 offset_from(const WideNode& node, const std::array<double, 3>& place, double scale) {
  return Vec3{place[0] - node.origin[0], place[1] - node.origin[1], place[2] - node.origin[2]} *
         scale;
}

/// Writes nodes, children before parents.
class NodeWriter {
 public:
  NodeWriter(const NodeSource& from, const Frame& frame, std::span<WideNode> nodes,
             std::span<TriangleId> least)
      : from_(from), frame_(frame), nodes_(nodes), least_(least) {
    moments_.resize(from.plan.size());
  }

  void run() {
    for (std::size_t i = from_.plan.size(); i-- > 0;) {
      write(i);
    }
  }

 private:
  void write(std::size_t i) {
    const WidePlan& plan = from_.plan[i];
    WideNode node;
    node.count = static_cast<std::uint8_t>(plan.count);
    node.origin = frame_.middle(from_.boxes[plan.box]);
    Moments moments;
    TriangleId least = std::numeric_limits<TriangleId>::max();
    std::array<LaneContent, WideNode::kWidth> content;
    for (std::uint32_t k = 0; k < plan.count; ++k) {
      const LanePlan& lane = plan.lanes[k];
      content[k] = {from_.boxes[lane.box],
                    from_.blocks.subspan(lane.first_block, lane.end_block - lane.first_block)};
      if (lane.is_leaf()) {
        set_leaf(node, k, from_.block_base + lane.first_block, lane.triangles);
        moments.add(moments_of_leaf(lane, node), {});
        least = std::min(least, least_id(content[k].blocks));
      } else {
        node.child[k] = from_.node_base + lane.child;
        moments.add(moments_[lane.child],
                    offset_from(node, nodes_[lane.child].origin, frame_.scale));
        least = std::min(least, least_[lane.child]);
      }
    }
    const Axes axes = plan.triangles <= kMostOriented ? axes_of(moments) : kMeshAxes;
    set_boxes(std::span(content).first(plan.count), axes, frame_, node);
    moments_[i] = moments;
    least_[i] = least;
    nodes_[i] = node;
  }

  [[nodiscard]] Moments moments_of_leaf(const LanePlan& lane, const WideNode& node) const {
    Moments sum;
    for (std::uint32_t b = lane.first_block; b < lane.end_block; ++b) {
      sum.add(from_.moments[b], offset_from(node, from_.blocks[b].origin, frame_.scale));
    }
    return sum;
  }

  const NodeSource& from_;
  const Frame& frame_;
  std::span<WideNode> nodes_;
  std::span<TriangleId> least_;
  Pages<Moments> moments_;  ///< about the nodes' origins
};

}  // namespace

Box LeafWriter::write(std::size_t first, std::size_t count, std::span<TriangleBlock> blocks,
                      std::span<Moments> moments) {
  constexpr std::size_t kWidth = TriangleBlock::kWidth;
  Box box;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t begin = b * kWidth;
    fetch_.reach(first + begin);
    const auto run = ids_.subspan(first + begin, std::min(count - begin, kWidth));
    const BlockContent content = make_block(mesh_, run, frame_, blocks[b]);
    blocks[b].following = static_cast<std::uint32_t>(blocks.size() - 1 - b) & (WideNode::kMost - 1);
    moments[b] = content.moments;
    box.grow(content.bounds);
  }
  return box;
}

TriangleId least_id(std::span<const TriangleBlock> blocks) {
  TriangleId least = std::numeric_limits<TriangleId>::max();
  for (const TriangleBlock& block : blocks) {
    // Lanes not in use repeat the last triangle.
    least = std::min(least, *std::min_element(block.id.begin(), block.id.end()));
  }
  return least;
}

PartContent write_blocks(std::span<const PartNode> part, std::span<const TriangleId> primitives,
                         const MeshView& mesh, const Frame& frame,
                         std::span<TriangleBlock> blocks) {
  PartContent content;
  content.first_block.resize(part.size() + 1);
  content.boxes.resize(part.size());
  content.moments.resize(blocks.size());
  const auto ids = primitives.subspan(part.front().first, part.front().count);
  LeafWriter leaves(mesh, ids, frame);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const PartNode& node = part[i];
    content.first_block[i] = next;
    if (node.is_leaf()) {
      const std::uint32_t count = blocks_for(node.count);
      content.boxes[i] =
          leaves.write(node.first - part.front().first, node.count, blocks.subspan(next, count),
                       std::span(content.moments).subspan(next, count));
      next += count;
    }
  }
  content.first_block.back() = next;
  // Children follow their parents, so the last node comes first.
  for (std::size_t i = part.size(); i-- > 0;) {
    if (!part[i].is_leaf()) {
      content.boxes[i] = content.boxes[i + 1];
      content.boxes[i].grow(content.boxes[part[i].right]);
    }
  }
  return content;
}

void write_nodes(const NodeSource& from, const Frame& frame, std::span<WideNode> nodes,
                 std::span<TriangleId> least) {
  NodeWriter(from, frame, nodes, least).run();
}

}  // namespace soms::layout
