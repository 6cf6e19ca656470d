#include "soms/query/detail/compact_traversal.h"

#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/triangle_tests.h"
#include "soms/tree/layout/compact_node.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are descended while neither is more than this much larger.
constexpr float kSimilar = 2;

/// Node tests that count as one unit of watched work: about those of a block.
constexpr std::uint64_t kBlockTests = TriangleBlock::kWidth;

constexpr std::uint32_t kIndexShift = 3;  // of a node id: see NodeTask

bool is_lane(std::uint32_t node_id) {
  return (node_id & NodeTask::kLane) != 0;
}

std::uint32_t lanes_of(const WideNode& node, std::uint32_t node_id) {
  return is_lane(node_id) ? 1U << (node_id & 3) : (1U << node.count) - 1;
}

std::uint32_t node_id_of(const WideNode& node, std::uint32_t own, std::uint32_t lane) {
  return (node.leaves >> lane & 1U) != 0 ? (own & ~7U) | NodeTask::kLane | lane
                                         : node.child[lane] << kIndexShift;
}

}  // namespace

SideReader::SideReader(const Shape& shape) : tree_(shape.layout()), mesh_(shape.mesh()) {
  if (tree_.compact() != nullptr) {
    kept_.fill(kNone);
    blocks_.resize(kKept);
  }
}

const WideNode& SideReader::node(std::uint32_t i) {
  if (tree_.compact() == nullptr) {
    return tree_.nodes()[i];
  }
  tree_.compact()->nodes[i].read(node_);
  return node_;
}

const TriangleBlock& SideReader::block(std::uint32_t token) {
  const std::uint32_t first = token & (WideNode::kMost - 1);
  if (tree_.compact() == nullptr) {
    return tree_.blocks()[first];
  }
  // Leaves have several triangles, so neighbors differ in more than the last bits.
  const std::size_t place = (first ^ first >> 5) % kKept;
  if (kept_[place] != first) {
    tree_.read_block(first, mesh_, blocks_[place]);
    kept_[place] = first;
  }
  return blocks_[place];
}

void CompactTraversal::run(Collector& collector, Watch& watch) {
  ++cost_.node_tests;
  if (relative_.apart()) {
    return;
  }
  pending_.assign(1, {0, 0});
  while (!pending_.empty()) {
    const Pair next = pending_.back();
    pending_.pop_back();
    const std::uint64_t tests = cost_.node_tests;
    // Leaves may be as large as a mesh.
    if (descend(next, collector, watch) ||
        watch.spend(2 + (cost_.node_tests - tests) / kBlockTests)) {
      return;
    }
  }
  static_cast<void>(leaves_.decide({}, true, collector, cost_));
}

bool CompactTraversal::descend(const Pair& pair, Collector& collector, Watch& watch) {
  const WideNode& x = x_.node(pair.x >> kIndexShift);
  const WideNode& y = y_.node(pair.y >> kIndexShift);
  NodeTask task = {};
  task.pose = &relative_.numbers();
  task.x = &x;
  task.y = &y;
  task.node_id_x = pair.x & ~7U;
  task.node_id_y = pair.y & ~7U;
  const float size_x = x.l1_radius * relative_.ratio();
  if (!is_lane(pair.x | pair.y) &&
      (size_x > kSimilar * y.l1_radius || y.l1_radius > kSimilar * size_x)) {
    const bool descends_x = task.descends_x();
    const std::uint32_t count = descends_x ? x.count : y.count;
    cost_.node_tests += count;
    task.pairs = (1U << count) - 1;
    kernels().test_larger(&task, 1);
    for (std::uint32_t left = task.pairs; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      pending_.push_back(descends_x ? Pair{node_id_of(x, pair.x, lane), pair.y}
                                    : Pair{pair.x, node_id_of(y, pair.y, lane)});
    }
    return false;
  }
  if (is_lane(pair.x | pair.y) && !large_leaf_meets(pair, x, y)) {
    return false;
  }
  const std::uint32_t in_x = lanes_of(x, pair.x);
  const std::uint32_t in_y = lanes_of(y, pair.y);
  cost_.node_tests += std::uint64_t{static_cast<unsigned>(std::popcount(in_x))} *
                      static_cast<unsigned>(std::popcount(in_y));
  task.pairs = kLanePairs.bits[in_x][in_y];
  kernels().test_nodes(&task, 1);
  for (std::uint32_t left = task.pairs; left != 0; left &= left - 1) {
    const auto bit = static_cast<std::uint32_t>(std::countr_zero(left));
    const std::uint32_t lane_x = bit % 4;
    const std::uint32_t lane_y = (lane_x + bit / 4) % 4;
    const Pair next{node_id_of(x, pair.x, lane_x), node_id_of(y, pair.y, lane_y)};
    if (!is_lane(next.x) || !is_lane(next.y)) {
      pending_.push_back(next);
    } else if (decide(x.child[lane_x], y.child[lane_y], collector, watch)) {
      return true;
    }
  }
  return false;
}

bool CompactTraversal::large_leaf_meets(const Pair& pair, const WideNode& x, const WideNode& y) {
  const bool of_x = is_lane(pair.x);
  const WideNode& node = of_x ? x : y;
  const std::uint32_t lane = (of_x ? pair.x : pair.y) & 3;
  const float size = std::max({node.half[0][lane], node.half[1][lane], node.half[2][lane]});
  if (of_x ? size * relative_.ratio() <= y.l1_radius : size <= x.l1_radius * relative_.ratio()) {
    return true;
  }
  Relation relation;
  for (std::uint32_t token = node.child[lane];;) {
    const TriangleBlock& block = of_x ? x_.block(token) : y_.block(token);
    cost_.node_tests += block.count;
    std::uint32_t meeting = 0;
    if (of_x) {
      relative_.relate(block, y, relation);
      meeting = box_against_x(relation, block, y.own_half());
    } else {
      relative_.relate(x, block, relation);
      meeting = box_against_y(relation, x.own_half(), block);
    }
    if (meeting != 0 || block.following == 0) {
      return meeting != 0;
    }
    token = of_x ? x_.next(token) : y_.next(token);
  }
}

bool CompactTraversal::decide(std::uint32_t token_x, std::uint32_t token_y, Collector& collector,
                              Watch& watch) {
  for (;; token_x = x_.next(token_x)) {
    const TriangleBlock& x = x_.block(token_x);
    const std::uint64_t tests = cost_.node_tests;
    for (std::uint32_t token = token_y;; token = y_.next(token)) {
      BlockTask task = {};
      task.pose = &relative_.numbers();
      task.x = &x;
      task.y = &y_.block(token);
      cost_.node_tests += task.x->count + task.y->count;
      kernels().test_slabs(&task, 1);
      if (leaves_.decide({&task, 1}, false, collector, cost_)) {
        return true;
      }
      if (task.y->following == 0) {
        break;
      }
    }
    if (x.following == 0) {
      return false;
    }
    if (watch.spend((cost_.node_tests - tests) / kBlockTests)) {
      return true;
    }
  }
}

}  // namespace soms::detail
