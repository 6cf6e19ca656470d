#include "soms/query/detail/wide_pair_traversal.h"

#include "soms/query/detail/fetch.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/single_box_descent.h"
#include "soms/query/detail/triangle_tests.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are descended while neither is more than this much larger.
constexpr float kSimilar = 2;

/// Pairs descended at once. Where bodies touch, a hit is mostly found within few pairs, and what
/// was descended beside the way to it is lost; a traversal that has gone on for long descends
/// everything anyway.
std::size_t group_of(std::size_t descended) {
  return descended < 24 ? 2 : descended < 48 ? 4 : TraversalRound::kEach;
}

/// Pairs descended with the nearest of their children first. It halves the way to a hit; a
/// traversal that has found none by then mostly finds none.
constexpr std::size_t kOrdered = 24;

constexpr std::uint32_t kIndexShift = 3;  // of a node id: see NodeTask

float longest(const std::array<float, 3>& half) {
  return std::max({half[0], half[1], half[2]});
}

std::size_t lowest(std::uint32_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
}

bool is_lane(std::uint32_t node_id) {
  return (node_id & NodeTask::kLane) != 0;
}

std::uint32_t lane_of(std::uint32_t node_id) {
  return node_id & 3;
}

/// What a node id means, without a branch that nobody could foresee.
struct CodeTable {
  struct Entry {
    std::uint8_t lanes = 0;
    std::uint8_t number = 0;
  };

  std::array<std::array<Entry, 8>, 5> entries = {};  // by the node's lanes and the id's last bits

  constexpr CodeTable() {
    for (std::uint32_t count = 0; count < 5; ++count) {
      for (std::uint32_t bits = 0; bits < 8; ++bits) {
        const bool lane = (bits & NodeTask::kLane) != 0;
        const std::uint32_t lanes = lane ? 1U << (bits & 3) : (1U << count) - 1;
        entries[count][bits] = {static_cast<std::uint8_t>(lanes),
                                static_cast<std::uint8_t>(lane ? 1 : count)};
      }
    }
  }
};

constexpr CodeTable kCodes;

/// Id of a node's child.
std::uint32_t node_id_of(const WideNode& node, std::uint32_t own, std::uint32_t lane) {
  return (node.leaves >> lane & 1U) != 0 ? own | NodeTask::kLane | lane
                                         : node.child[lane] << kIndexShift;
}

}  // namespace

PairTraversal::PairTraversal(RelativePose& relative, const TraversalSide& x, const TraversalSide& y,
                             bool swapped, OverlapMode mode, TraversalMemory& memory)
    : relative_(relative),
      leaves_(x, y, swapped, memory.leaves),
      nodes_x_(x.shape->layout().nodes().data()),
      nodes_y_(y.shape->layout().nodes().data()),
      blocks_x_(x.shape->layout().blocks().data()),
      blocks_y_(y.shape->layout().blocks().data()),
      grid_y_(y.shape->layout().min_max_grid()),
      kernels_(kernels()),
      nearest_first_(mode == OverlapMode::any),
      memory_(memory) {
}

void PairTraversal::start() {
  ++cost_.node_tests;
  memory_.clear();
  if (relative_.apart()) {
    return;
  }
  const SingleBox box = relative_.single_box();
  if (box.pays(nodes_y_[0])) {
    if (grid_y_.empty() || !box.clear_of(grid_y_)) {
      box.descend(nodes_y_, memory_.blocks, memory_.node_ids, cost_);
    }
  } else {
    memory_.node_ids.push({0, 0});
  }
  if (!memory_.node_ids.empty()) {
    relative_.prepare();
  }
}

void PairTraversal::start(const PairList& seeds, const Cost& cost) {
  cost_ = cost;
  memory_.clear();
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    memory_.node_ids.push(seeds.at(i));
  }
  relative_.prepare();
}

void PairTraversal::start(const NodeRefPair& from) {
  memory_.clear();
  (from.blocks() ? memory_.blocks : memory_.node_ids).push(from);
}

void PairTraversal::push(const NodeTask& task) {
  const bool descends_x = task.descends_x();
  for (std::uint32_t meet = task.pairs; meet != 0; meet &= meet - 1) {
    const auto lane = static_cast<std::uint32_t>(lowest(meet));
    if (descends_x) {
      const std::uint32_t node_id = node_id_of(*task.x, task.node_id_x, lane);
      memory_.node_ids.push({node_id, task.node_id_y});
      fetch(nodes_x_[node_id >> kIndexShift]);
    } else {
      const std::uint32_t node_id = node_id_of(*task.y, task.node_id_y, lane);
      memory_.node_ids.push({task.node_id_x, node_id});
      fetch(nodes_y_[node_id >> kIndexShift]);
    }
  }
}

bool PairTraversal::large_leaf_meets(const NodeRefPair& pair, const WideNode& x,
                                     const WideNode& y) {
  Relation relation;
  if (is_lane(pair.x)) {
    const std::uint32_t lane = lane_of(pair.x);
    const float size = longest({x.half[0][lane], x.half[1][lane], x.half[2][lane]});
    if (size * relative_.ratio() <= y.l1_radius) {
      return true;
    }
    for (const TriangleBlock* block = &block_x(x.child[lane]);; ++block) {
      relative_.relate(*block, y, relation);
      cost_.node_tests += block->count;
      ++scanned_;
      if (box_against_x(relation, *block, y.own_half()) != 0) {
        return true;
      }
      if (block->following == 0) {
        return false;
      }
    }
  }
  const std::uint32_t lane = lane_of(pair.y);
  const float size = longest({y.half[0][lane], y.half[1][lane], y.half[2][lane]});
  if (size <= x.l1_radius * relative_.ratio()) {
    return true;
  }
  for (const TriangleBlock* block = &block_y(y.child[lane]);; ++block) {
    relative_.relate(x, *block, relation);
    cost_.node_tests += block->count;
    ++scanned_;
    if (box_against_y(relation, x.own_half(), *block) != 0) {
      return true;
    }
    if (block->following == 0) {
      return false;
    }
  }
}

void PairTraversal::gather_nodes(TraversalRound& round) {
  PairList& node_ids = memory_.node_ids;
  const std::size_t taken = std::min(group_of(descended_), node_ids.size());
  const std::uint32_t order = nearest_first_ && descended_ < kOrdered ? 1 : 0;
  descended_ += taken;
  node_ids.drop(taken);
  const PoseNumbers& numbers = relative_.numbers();
  NodeTask* next = round.nodes.data() + round.node_count;
  // What was on top comes last, so that its children end on top.
  for (std::size_t i = node_ids.size(); i < node_ids.size() + taken; ++i) {
    const NodeRefPair pair = node_ids.at(i);
    const WideNode& x = nodes_x_[pair.x >> kIndexShift];
    const WideNode& y = nodes_y_[pair.y >> kIndexShift];
    const float size_x = x.l1_radius * numbers.ratio;
    if (size_x > kSimilar * y.l1_radius || y.l1_radius > kSimilar * size_x) {
      if (!is_lane(pair.x | pair.y)) {
        const std::uint32_t count = size_x > y.l1_radius ? x.count : y.count;
        cost_.node_tests += count;
        round.larger[round.larger_count++] = {&numbers,          &x, &y, pair.x, pair.y,
                                              (1U << count) - 1, 0,  0};
        continue;
      }
      if (!large_leaf_meets(pair, x, y)) {
        continue;
      }
    }
    const CodeTable::Entry& in_x = kCodes.entries[x.count][pair.x & 7];
    const CodeTable::Entry& in_y = kCodes.entries[y.count][pair.y & 7];
    cost_.node_tests += std::uint64_t{in_x.number} * in_y.number;
    *next++ = {
        &numbers, &x, &y, pair.x & ~7U, pair.y & ~7U, kLanePairs.bits[in_x.lanes][in_y.lanes],
        order,    0};
  }
  round.node_count = static_cast<std::size_t>(next - round.nodes.data());
}

void PairTraversal::append(std::span<const NodeTask> tasks) {
  PairList& node_ids = memory_.node_ids;
  PairList& blocks = memory_.blocks;
  constexpr std::size_t kMost = 16;
  node_ids.reserve(kMost * (tasks.size() + 1));
  blocks.reserve(kMost * (tasks.size() + 1));
  PairSink sink{node_ids.end_x(), node_ids.end_y(), blocks.end_x(), blocks.end_y()};
  kernels_.append(tasks.data(), tasks.size(), sink);
  node_ids.add(sink.node_ids);
  blocks.add(sink.blocks);
  const std::size_t next = std::min(group_of(descended_), node_ids.size());
  for (std::size_t i = node_ids.size() - next; i < node_ids.size(); ++i) {
    const NodeRefPair pair = node_ids.at(i);
    fetch(nodes_x_[pair.x >> kIndexShift]);
    fetch(nodes_y_[pair.y >> kIndexShift]);
  }
  for (std::size_t i = blocks.size() - sink.blocks; i < blocks.size(); ++i) {
    const NodeRefPair pair = blocks.at(i);
    fetch(block_x(pair.x));
    fetch(block_y(pair.y));
  }
}

bool PairTraversal::gather(TraversalRound& round) {
  node_begin_ = round.node_count;
  larger_begin_ = round.larger_count;
  block_begin_ = round.block_count;
  scanned_ = 0;
  if (!memory_.blocks.empty()) {
    gather_blocks(round);
  } else if (!memory_.node_ids.empty()) {
    gather_nodes(round);
  } else {
    return false;
  }
  node_count_ = round.node_count - node_begin_;
  larger_count_ = round.larger_count - larger_begin_;
  block_count_ = round.block_count - block_begin_;
  return true;
}

void PairTraversal::test(const Kernels& kernels, TraversalRound& round) {
  kernels.test_nodes(round.nodes.data(), round.node_count);
  kernels.test_larger(round.larger.data(), round.larger_count);
  kernels.test_slabs(round.blocks.data(), round.block_count);
}

bool PairTraversal::take_up(const TraversalRound& round, Collector& collector, Watch& watch) {
  for (std::size_t i = 0; i < larger_count_; ++i) {
    push(round.larger[larger_begin_ + i]);
  }
  if (node_count_ != 0) {
    append(std::span(round.nodes).subspan(node_begin_, node_count_));
  }
  const bool last = memory_.node_ids.empty() && memory_.blocks.empty();
  if ((block_count_ != 0 || last) &&
      leaves_.decide(std::span(round.blocks).subspan(block_begin_, block_count_), last, collector,
                     cost_)) {
    return false;
  }
  return !watch.spend(1 + node_count_ + larger_count_ + 2 * block_count_ + scanned_);
}

void PairTraversal::run(Collector& collector, Watch& watch) {
  TraversalRound round;
  while (gather(round)) {
    test(kernels_, round);
    if (!take_up(round, collector, watch)) {
      return;
    }
    round.clear();
  }
}

std::vector<NodeRefPair> PairTraversal::frontier(std::size_t enough) {
  start();
  std::vector<NodeRefPair> level;
  for (std::size_t i = 0; i < memory_.node_ids.size(); ++i) {
    level.push_back(memory_.node_ids.at(i));
  }
  std::vector<NodeRefPair> next;
  bool descended = true;
  while (descended && level.size() < enough) {
    next.clear();
    descended = false;
    for (const NodeRefPair& pair : level) {
      if (pair.blocks()) {
        next.push_back(pair);
        continue;
      }
      start(pair);
      TraversalRound round;
      gather_nodes(round);
      test(kernels_, round);
      for (std::size_t i = 0; i < round.larger_count; ++i) {
        push(round.larger[i]);
      }
      append(std::span(round.nodes).first(round.node_count));
      for (const PairList* list : {&memory_.blocks, &memory_.node_ids}) {
        for (std::size_t i = 0; i < list->size(); ++i) {
          next.push_back(list->at(i));
        }
      }
      descended = true;
    }
    level.swap(next);
  }
  return level;
}

NodeRefPair PairTraversal::take_blocks() {
  constexpr std::uint32_t kRun = WideNode::kRunBit;
  const NodeRefPair pair = memory_.blocks.pop();
  const NodeRefPair here{pair.x & ~kRun, pair.y & ~kRun};
  // Row by row: only the head of a row, whose y is still a run too, goes on to the next row.
  if ((pair.x & kRun) != 0 && block_x(here.x).following > 0) {
    memory_.blocks.push({pair.x + 1, pair.y});
  }
  if ((pair.y & kRun) != 0 && block_y(here.y).following > 0) {
    memory_.blocks.push({here.x, pair.y + 1});
  }
  return here;
}

void PairTraversal::gather_blocks(TraversalRound& round) {
  for (std::size_t i = 0; i < TraversalRound::kEach && !memory_.blocks.empty(); ++i) {
    const NodeRefPair pair = take_blocks();
    BlockTask& task = round.blocks[round.block_count++];
    task.pose = &relative_.numbers();
    task.x = &block_x(pair.x);
    task.y = &block_y(pair.y);
    cost_.node_tests += task.x->count + task.y->count;
  }
}

}  // namespace soms::detail
