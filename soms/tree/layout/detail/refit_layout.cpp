#include "soms/tree/layout/detail/refit_layout.h"

#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/lay_out.h"
#include "soms/tree/layout/detail/node_boxes.h"

#include <algorithm>
#include <vector>

namespace soms::layout {

namespace {

constexpr std::size_t kTrianglesPerChunk = 32768;

std::uint32_t first_block(std::uint32_t child) {
  return child & (WideNode::kMost - 1);
}

std::uint32_t triangles_of_leaf(const TriangleBlock* first) {
  const std::uint32_t more = first->following;
  return more * TriangleBlock::kWidth + first[more].count;
}

/// What lies in a node and below it.
struct Below {
  std::uint32_t triangles = 0;
  std::uint32_t nodes = 1;
  std::uint32_t first_block = WideNode::kMost;
  std::uint32_t blocks = 0;

  void add(const Below& child) {
    triangles += child.triangles;
    nodes += child.nodes;
    first_block = std::min(first_block, child.first_block);
    blocks += child.blocks;
  }
};

Below below_leaf(const WideTree& tree, std::uint32_t child) {
  const std::uint32_t block = first_block(child);
  const std::uint32_t triangles = triangles_of_leaf(&tree.blocks()[block]);
  return {triangles, 0, block, blocks_for(triangles)};
}

bool is_leaf(const WideNode& node, std::size_t k) {
  return (std::uint32_t{node.leaves} >> k & 1U) != 0;
}

/// Children follow their parents, so the last node comes first.
std::vector<Below> count_below(const WideTree& tree) {
  std::vector<Below> below(tree.nodes().size());
  for (std::size_t i = below.size(); i-- > 0;) {
    const WideNode& node = tree.nodes()[i];
    for (std::size_t k = 0; k < node.count; ++k) {
      below[i].add(is_leaf(node, k) ? below_leaf(tree, node.child[k]) : below[node.child[k]]);
    }
  }
  return below;
}

/// The place of a part: a node with all below it, or a leaf beside such nodes.
struct Place {
  std::uint32_t parent = Node::kNone;  ///< an upper node, and its lane; none: it is the whole tree
  std::uint32_t lane = 0;
  bool leaf = false;
  std::uint32_t node = 0;  ///< where the part's nodes begin
  Below below;
};

struct Recovered {
  std::vector<std::uint32_t> upper;  ///< nodes above the parts, parents before children
  std::vector<Place> places;
};

Recovered recover(const WideTree& tree, const std::vector<Below>& below) {
  Recovered found;
  if (below[0].triangles <= kPartTriangles) {
    found.places.push_back({Node::kNone, 0, false, 0, below[0]});
    return found;
  }
  found.upper.push_back(0);
  for (std::size_t i = 0; i < found.upper.size(); ++i) {
    const std::uint32_t at = found.upper[i];
    const WideNode& node = tree.nodes()[at];
    for (std::uint32_t k = 0; k < node.count; ++k) {
      const std::uint32_t child = node.child[k];
      if (is_leaf(node, k)) {
        found.places.push_back({at, k, true, 0, below_leaf(tree, child)});
      } else if (below[child].triangles <= kPartTriangles) {
        found.places.push_back({at, k, false, child, below[child]});
      } else {
        found.upper.push_back(child);
      }
    }
  }
  std::sort(found.upper.begin(), found.upper.end());
  return found;
}

/// One part as `widen` had it. Boxes are those of its wide nodes, then of its leaves, by the first
/// block of each.
class RefitPart {
 public:
  RefitPart(const WideTree& tree, const Place& place)
      : tree_(tree),
        from_(tree.blocks().subspan(place.below.first_block, place.below.blocks)),
        node_base_(place.node),
        block_base_(place.below.first_block) {
    plan_.resize(place.below.nodes);
    for (std::uint32_t i = 0; i < plan_.size(); ++i) {
      plan(i);
    }
  }

  /// Writes it over moved vertices and returns its bounds.
  Box write(const MeshView& mesh, const Frame& frame, std::span<WideNode> nodes,
            std::span<TriangleBlock> blocks) {
    const auto own = blocks.subspan(block_base_, from_.size());
    write_leaves(mesh, frame, own);
    for (std::size_t i = plan_.size(); i-- > 0;) {
      gather_below(plan_[i]);
    }
    Pages<TriangleId> least;
    least.resize(plan_.size());
    write_nodes({plan_, boxes_, moments_, own, node_base_, block_base_}, frame,
                nodes.subspan(node_base_, plan_.size()), least);
    return boxes_.front();
  }

 private:
  [[nodiscard]] std::uint32_t box_of_leaf(std::uint32_t block) const {
    return static_cast<std::uint32_t>(plan_.size()) + block;
  }

  void plan(std::uint32_t i) {
    const WideNode& node = tree_.nodes()[node_base_ + i];
    WidePlan& wide = plan_[i];
    wide.box = i;
    wide.count = node.count;
    for (std::uint32_t k = 0; k < node.count; ++k) {
      LanePlan& lane = wide.lanes[k];
      if (is_leaf(node, k)) {
        lane.first_block = first_block(node.child[k]) - block_base_;
        lane.end_block = lane.first_block + from_[lane.first_block].following + 1;
        lane.triangles = triangles_of_leaf(&from_[lane.first_block]);
        lane.box = box_of_leaf(lane.first_block);
      } else {
        lane.child = lane.box = node.child[k] - node_base_;
      }
    }
  }

  void write_leaves(const MeshView& mesh, const Frame& frame, std::span<TriangleBlock> blocks) {
    std::vector<TriangleId> ids;
    ids.reserve(from_.size() * TriangleBlock::kWidth);
    for (const TriangleBlock& block : from_) {
      ids.insert(ids.end(), block.id.begin(), block.id.begin() + block.count);
    }
    boxes_.resize(plan_.size() + blocks.size());
    moments_.resize(blocks.size());
    LeafWriter leaves(mesh, ids, frame);
    std::size_t next = 0;
    for (std::uint32_t b = 0; b < blocks.size();) {
      const std::uint32_t count = from_[b].following + 1;
      const std::uint32_t triangles = triangles_of_leaf(&from_[b]);
      boxes_[box_of_leaf(b)] = leaves.write(next, triangles, blocks.subspan(b, count),
                                            std::span(moments_).subspan(b, count));
      next += triangles;
      b += count;
    }
  }

  /// Bounds, count and blocks of a wide node from those of its lanes; children were there before.
  void gather_below(WidePlan& wide) {
    Box& box = boxes_[wide.box];
    box = {};
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      LanePlan& lane = wide.lanes[k];
      if (!lane.is_leaf()) {
        const WidePlan& below = plan_[lane.child];
        lane.triangles = below.triangles;
        lane.first_block = below.lanes[0].first_block;
        for (const LanePlan& other : below.used()) {
          lane.first_block = std::min(lane.first_block, other.first_block);
          lane.end_block = std::max(lane.end_block, other.end_block);
        }
      }
      box.grow(boxes_[lane.box]);
      wide.triangles += lane.triangles;
    }
  }

  const WideTree& tree_;
  std::span<const TriangleBlock> from_;  ///< the part's blocks as they were
  std::uint32_t node_base_;
  std::uint32_t block_base_;
  std::vector<WidePlan> plan_;
  Pages<Box> boxes_;
  Pages<Moments> moments_;
};

}  // namespace

Box bounds_of(const MeshView& mesh, const Limits& limits) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Box> boxes((count + kTrianglesPerChunk - 1) / kTrianglesPerChunk);
  for_each_chunk(count, kTrianglesPerChunk, {.threads = limits.threads, .stop = limits.stop},
                 [&](std::size_t begin, std::size_t end) {
                   Box box;
                   for (std::size_t i = begin; i < end; ++i) {
                     for (const std::uint32_t corner : mesh.triangles[i]) {
                       box.grow(mesh.vertices[corner]);
                     }
                   }
                   boxes[begin / kTrianglesPerChunk] = box;
                 });
  Box box;
  for (const Box& b : boxes) {
    box.grow(b);
  }
  return box;
}

void refit_layout(const WideTree& tree, const MeshView& mesh, const Frame& frame,
                  const Limits& limits, std::span<WideNode> nodes,
                  std::span<TriangleBlock> blocks) {
  const Recovered found = recover(tree, count_below(tree));
  std::vector<Box> part_bounds(found.places.size());
  for_each_chunk(found.places.size(), 1, limits, [&](std::size_t k, std::size_t) {
    part_bounds[k] = RefitPart(tree, found.places[k]).write(mesh, frame, nodes, blocks);
  });
  // Boxes of the lanes of each upper node, and its own, the last node first.
  std::vector<std::array<LaneContent, WideNode::kWidth>> lanes(found.upper.size());
  const auto place_of = [&](std::uint32_t node) {
    return static_cast<std::size_t>(std::lower_bound(found.upper.begin(), found.upper.end(), node) -
                                    found.upper.begin());
  };
  std::vector<Box> whole(found.upper.size());
  for (std::size_t k = 0; k < found.places.size(); ++k) {
    if (found.places[k].parent != Node::kNone) {
      lanes[place_of(found.places[k].parent)][found.places[k].lane].bounds = part_bounds[k];
    }
  }
  for (std::size_t i = found.upper.size(); i-- > 0;) {
    const WideNode& from = tree.nodes()[found.upper[i]];
    for (std::size_t k = 0; k < from.count; ++k) {
      if (!is_leaf(from, k) &&
          std::binary_search(found.upper.begin(), found.upper.end(), from.child[k])) {
        lanes[i][k].bounds = whole[place_of(from.child[k])];
      }
      whole[i].grow(lanes[i][k].bounds);
    }
    WideNode node;
    node.count = from.count;
    node.leaves = from.leaves;
    node.child = from.child;
    node.origin = frame.middle(whole[i]);
    set_boxes(std::span(lanes[i]).first(node.count), kMeshAxes, frame, node);
    nodes[found.upper[i]] = node;
  }
}

}  // namespace soms::layout
