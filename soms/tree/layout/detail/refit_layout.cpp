#include "soms/tree/layout/detail/refit_layout.h"

#include "soms/tree/layout/detail/fetch_corners.h"
#include "soms/tree/layout/detail/lay_out.h"
#include "soms/tree/layout/detail/widen.h"

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

/// One part as `widen` had it: its wide nodes and their leaves are its nodes, in this order.
class RefitLayout {
 public:
  RefitLayout(const WideTree& tree, const Place& place) : tree_(tree) {
    plan_.node_base = place.node;
    plan_.block_base = place.below.first_block;
    plan_.blocks = place.below.blocks;
    ids_.reserve(place.below.triangles);
    if (place.leaf) {
      add_leaf(place.below.first_block);
      return;
    }
    plan_.nodes.resize(place.below.nodes);
    nodes_.resize(place.below.nodes);
    for (std::uint32_t i = 0; i < place.below.nodes; ++i) {
      add(i);
    }
  }

  /// Writes it over moved vertices and returns its bounds.
  Box write(const Mesh& mesh, const Frame& frame, std::span<WideNode> nodes,
            std::span<TriangleBlock> blocks) {
    find_bounds(mesh);
    lay_out({nodes_, 0}, plan_, ids_, mesh, frame,
            nodes.subspan(plan_.node_base, plan_.nodes.size()),
            blocks.subspan(plan_.block_base, plan_.blocks));
    return nodes_.front().bounds;
  }

 private:
  void add(std::uint32_t i) {
    const WideNode& node = tree_.nodes()[plan_.node_base + i];
    WidePlan& wide = plan_.nodes[i];
    wide.binary = i;
    wide.count = node.count;
    for (std::uint32_t k = 0; k < node.count; ++k) {
      if (is_leaf(node, k)) {
        const std::uint32_t block = first_block(node.child[k]);
        wide.slots[k] = static_cast<std::uint32_t>(nodes_.size());
        wide.child[k] = block - plan_.block_base;
        add_leaf(block);
      } else {
        wide.child[k] = wide.slots[k] = node.child[k] - plan_.node_base;
      }
    }
  }

  void add_leaf(std::uint32_t block) {
    Node leaf;
    leaf.first = static_cast<std::uint32_t>(ids_.size());
    leaf.count = triangles_of_leaf(&tree_.blocks()[block]);
    for (std::uint32_t left = leaf.count; left > 0; ++block) {
      const TriangleBlock& from = tree_.blocks()[block];
      ids_.insert(ids_.end(), from.id.begin(), from.id.begin() + from.count);
      left -= from.count;
    }
    nodes_.push_back(leaf);
  }

  void find_bounds(const Mesh& mesh) {
    fetch_corners(mesh, ids_);
    for (std::size_t i = plan_.nodes.size(); i < nodes_.size(); ++i) {
      Node& leaf = nodes_[i];
      for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
        leaf.bounds.grow(bounds(mesh.triangle(ids_[k])));
      }
    }
    for (std::size_t i = plan_.nodes.size(); i-- > 0;) {
      gather_below(i);
    }
    nodes_.front().count = static_cast<std::uint32_t>(ids_.size());
  }

  /// Bounds, count and blocks of a wide node from those of its lanes.
  void gather_below(std::size_t i) {
    WidePlan& wide = plan_.nodes[i];
    Node& node = nodes_[i];
    node.left = 0;  // it is no leaf
    wide.first_block = plan_.blocks;
    for (std::uint32_t k = 0; k < wide.count; ++k) {
      const Node& lane = nodes_[wide.slots[k]];
      node.bounds.grow(lane.bounds);
      node.count += lane.count;
      const bool leaf = lane.is_leaf();
      const std::uint32_t first = leaf ? wide.child[k] : plan_.nodes[wide.child[k]].first_block;
      const std::uint32_t end =
          leaf ? first + blocks_for(lane.count) : plan_.nodes[wide.child[k]].end_block;
      wide.first_block = std::min(wide.first_block, first);
      wide.end_block = std::max(wide.end_block, end);
    }
  }

  const WideTree& tree_;
  PartPlan plan_;
  std::vector<Node> nodes_;
  std::vector<TriangleId> ids_;
};

}  // namespace

Box bounds_of(const Mesh& mesh, const Parallel& parallel) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Box> boxes((count + kTrianglesPerChunk - 1) / kTrianglesPerChunk);
  for_each_chunk(count, kTrianglesPerChunk, {parallel.threads, parallel.stop, {}},
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

void refit_layout(const WideTree& tree, const Mesh& mesh, const Frame& frame,
                  const Parallel& parallel, std::span<WideNode> nodes,
                  std::span<TriangleBlock> blocks) {
  const Recovered found = recover(tree, count_below(tree));
  std::vector<Box> part_bounds(found.places.size());
  for_each_chunk(found.places.size(), 1, parallel, [&](std::size_t k, std::size_t) {
    part_bounds[k] = RefitLayout(tree, found.places[k]).write(mesh, frame, nodes, blocks);
  });
  // Boxes of the lanes of each upper node, and its own, the last node first.
  std::vector<std::array<Box, WideNode::kWidth>> boxes(found.upper.size());
  const auto place_of = [&](std::uint32_t node) {
    return static_cast<std::size_t>(std::lower_bound(found.upper.begin(), found.upper.end(), node) -
                                    found.upper.begin());
  };
  std::vector<Box> whole(found.upper.size());
  for (std::size_t k = 0; k < found.places.size(); ++k) {
    if (found.places[k].parent != Node::kNone) {
      boxes[place_of(found.places[k].parent)][found.places[k].lane] = part_bounds[k];
    }
  }
  for (std::size_t i = found.upper.size(); i-- > 0;) {
    const WideNode& from = tree.nodes()[found.upper[i]];
    for (std::size_t k = 0; k < from.count; ++k) {
      if (!is_leaf(from, k) &&
          std::binary_search(found.upper.begin(), found.upper.end(), from.child[k])) {
        boxes[i][k] = whole[place_of(from.child[k])];
      }
      whole[i].grow(boxes[i][k]);
    }
    WideNode node;
    node.count = from.count;
    node.leaves = from.leaves;
    node.child = from.child;
    store_upper(whole[i], boxes[i], frame, node);
    nodes[found.upper[i]] = node;
  }
}

}  // namespace soms::layout
