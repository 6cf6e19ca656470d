#include "thesis/races/earlier_nodes.h"

#include <algorithm>
#include <utility>

namespace soms::reproduce {

namespace {

std::size_t depth_of_tree(const Tree& tree) {
  std::size_t depth = 0;
  for (const Node& node : tree.nodes) {
    depth = std::max<std::size_t>(depth, node.depth);
  }
  return depth;
}

/// Nodes that hold each triangle: at each depth, or the leaf above it.
using NodesByDepth = std::vector<std::vector<std::uint32_t>>;

NodesByDepth nodes_by_depth(const Tree& tree, std::size_t depths) {
  NodesByDepth at(depths, std::vector<std::uint32_t>(tree.primitives.size()));
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    for (const TriangleId id : tree.triangles_of(node)) {
      for (std::size_t d = node.depth; d < (node.is_leaf() ? depths : node.depth + 1U); ++d) {
        at[d][id] = i;
      }
    }
  }
  return at;
}

/// Counts of one frame by the depth of the pairs: a pair's is that of its deeper node, and a cut at
/// a depth ends at pairs of that depth, and above it at pairs of leaves.
class LevelWatcher {
 public:
  LevelWatcher(const MovedTrip& moved, std::size_t depths)
      : a_(*moved.trip().a.tree()), b_(*moved.trip().b.tree()), depths_(depths) {}

  void look(FrameTraversal& traversal, std::size_t frame) {
    tests_.assign(depths_, 0);
    inner_.assign(depths_, 0);
    leaves_.assign(depths_, 0);
    first_.assign(depths_, 0);
    pending_.assign(depths_, false);
    const TraversalVisitor visitor{.tested = [&](NodePair pair, bool hit) { test(pair, hit); },
                                   .entered = [&](NodePair) { end_family(); }};
    traversal.run(frame, visitor);
    end_family();
  }

  /// Adds the frame to the sums of all levels.
  void add_to(std::vector<EarlierLevel>& levels, std::size_t frame) const {
    std::uint64_t tests = 0;
    std::uint64_t entered = 0;
    std::uint64_t leaves = 0;
    for (std::size_t d = 0; d < depths_; ++d) {
      tests += tests_[d];
      leaves += leaves_[d];
      EarlierLevel& level = levels[d];
      const std::uint64_t pairs = leaves + inner_[d];
      level.box_tests += tests;
      level.entered += entered;
      level.first_tests += first_[d];
      level.pairs += pairs;
      if (pairs > 0) {
        ++level.called_frames;
        level.first_frame = std::min(level.first_frame, frame);
      }
      entered += inner_[d];
    }
  }

 private:
  void test(NodePair pair, bool hit) {
    const Node& a = a_.nodes[pair.a];
    const Node& b = b_.nodes[pair.b];
    const std::size_t depth = std::max(a.depth, b.depth);
    ++tests_[depth];
    if (!hit) {
      return;
    }
    const bool leaves = a.is_leaf() && b.is_leaf();
    ++(leaves ? leaves_ : inner_)[depth];
    const std::size_t end = leaves ? depths_ : depth + 1;
    for (std::size_t d = depth; d < end; ++d) {
      if (first_[d] == 0) {
        pending_[d] = true;
        waits_ = true;
      }
    }
  }

  /// Children of one pair are all tested before one of them is reported.
  void end_family() {
    if (!waits_) {
      return;
    }
    waits_ = false;
    std::uint64_t tests = 0;
    for (std::size_t d = 0; d < depths_; ++d) {
      tests += tests_[d];
      if (pending_[d]) {
        first_[d] = tests;
        pending_[d] = false;
      }
    }
  }

  const Tree& a_;
  const Tree& b_;
  std::size_t depths_;
  std::vector<std::uint64_t> tests_ = {};
  std::vector<std::uint64_t> inner_ = {};   ///< overlapping pairs that can be divided
  std::vector<std::uint64_t> leaves_ = {};  ///< overlapping pairs of leaves
  std::vector<std::uint64_t> first_ = {};   ///< tests up to the first pair; 0 before there is one
  std::vector<bool> pending_ = {};          ///< there is one, in the family that is being tested
  bool waits_ = false;
};

/// Pairs of nodes, cut at a depth, that hold triangles which touch.
std::uint64_t touching_pairs(const Frame& frame, const std::vector<std::uint32_t>& of_a,
                             const std::vector<std::uint32_t>& of_b,
                             std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
  pairs.clear();
  for (const auto& [i, j] : frame.contacts) {
    pairs.emplace_back(of_a[i], of_b[j]);
  }
  std::sort(pairs.begin(), pairs.end());
  return static_cast<std::uint64_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

}  // namespace

std::vector<EarlierLevel> earlier_nodes(const MovedTrip& moved, std::span<const Frame> exact,
                                        const Limits& limits) {
  const Tree& a = *moved.trip().a.tree();
  const Tree& b = *moved.trip().b.tree();
  const std::size_t depths = std::max(depth_of_tree(a), depth_of_tree(b)) + 1;
  const NodesByDepth of_a = nodes_by_depth(a, depths);
  const NodesByDepth of_b = nodes_by_depth(b, depths);
  std::vector<EarlierLevel> levels(depths);
  const TripRacer racer{"enode_both", {.traversal = Traversal::e_node}};
  FrameTraversal traversal(moved, racer);
  LevelWatcher watcher(moved, depths);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (std::size_t k = 0; k < moved.frames(); ++k) {
    check_stop(limits);
    watcher.look(traversal, k);
    watcher.add_to(levels, k);
    for (std::size_t d = 0; d < depths && !exact[k].contacts.empty(); ++d) {
      levels[d].touching_pairs += touching_pairs(exact[k], of_a[d], of_b[d], pairs);
    }
  }
  return levels;
}

}  // namespace soms::reproduce
