#include "soms/query/detail/pair_walk.h"

#include "soms/query/detail/fetch.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/lone_box.h"
#include "soms/query/detail/triangle_tests.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are opened while neither is more than this much larger.
constexpr float kSimilar = 2;

/// Pairs opened at once. Where bodies touch, a hit is mostly found within few pairs, and what was
/// opened beside the way to it is lost; a walk that has gone on for long opens everything anyway.
std::size_t group_of(std::size_t opened) {
  return opened < 24 ? 2 : opened < 48 ? 4 : WalkRound::kEach;
}

/// Pairs opened with the nearest of their children first. It halves the way to a hit; a walk that
/// has found none by then mostly finds none.
constexpr std::size_t kOrdered = 24;

constexpr std::uint32_t kIndexShift = 3;  // of a code: see NodeTask

float longest(const std::array<float, 3>& half) {
  return std::max({half[0], half[1], half[2]});
}

std::size_t lowest(std::uint32_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
}

bool is_lane(std::uint32_t code) {
  return (code & NodeTask::kLane) != 0;
}

std::uint32_t lane_of(std::uint32_t code) {
  return code & 3;
}

/// What a code means, without a branch that nobody could foresee.
struct CodeTable {
  struct Entry {
    std::uint8_t lanes = 0;
    std::uint8_t number = 0;
  };

  std::array<std::array<Entry, 8>, 5> entries = {};  // by the node's lanes and the code's last bits

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

/// Code of a node's child.
std::uint32_t code_of(const WideNode& node, std::uint32_t own, std::uint32_t lane) {
  return (node.leaves >> lane & 1U) != 0 ? own | NodeTask::kLane | lane
                                         : node.child[lane] << kIndexShift;
}

}  // namespace

PairWalk::PairWalk(RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
                   OverlapMode mode, WalkMemory& memory)
    : relative_(relative),
      leaves_(x, y, swapped, memory.leaves),
      nodes_x_(x.shape->layout().nodes().data()),
      nodes_y_(y.shape->layout().nodes().data()),
      blocks_x_(x.shape->layout().blocks().data()),
      blocks_y_(y.shape->layout().blocks().data()),
      columns_y_(y.shape->layout().columns()),
      kernels_(kernels()),
      nearest_first_(mode == OverlapMode::any),
      memory_(memory) {
}

void PairWalk::start() {
  ++cost_.node_tests;
  memory_.clear();
  if (relative_.apart()) {
    return;
  }
  const LoneBox box = relative_.lone_box();
  if (box.pays(nodes_y_[0])) {
    if (columns_y_.empty() || !box.clear_of(columns_y_)) {
      box.descend(nodes_y_, memory_.blocks, memory_.codes, cost_);
    }
  } else {
    memory_.codes.push({0, 0});
  }
  if (!memory_.codes.empty()) {
    relative_.prepare();
  }
}

void PairWalk::start(const PairList& seeds, const Cost& cost) {
  cost_ = cost;
  memory_.clear();
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    memory_.codes.push(seeds.at(i));
  }
  relative_.prepare();
}

void PairWalk::start(const PlacePair& from) {
  memory_.clear();
  (from.blocks() ? memory_.blocks : memory_.codes).push(from);
}

void PairWalk::push(const NodeTask& task) {
  const bool opens_x = task.opens_x();
  for (std::uint32_t meet = task.pairs; meet != 0; meet &= meet - 1) {
    const auto lane = static_cast<std::uint32_t>(lowest(meet));
    if (opens_x) {
      const std::uint32_t code = code_of(*task.x, task.code_x, lane);
      memory_.codes.push({code, task.code_y});
      fetch(nodes_x_[code >> kIndexShift]);
    } else {
      const std::uint32_t code = code_of(*task.y, task.code_y, lane);
      memory_.codes.push({task.code_x, code});
      fetch(nodes_y_[code >> kIndexShift]);
    }
  }
}

bool PairWalk::large_leaf_meets(const PlacePair& pair, const WideNode& x, const WideNode& y) {
  Relation relation;
  if (is_lane(pair.x)) {
    const std::uint32_t lane = lane_of(pair.x);
    const float size = longest({x.half[0][lane], x.half[1][lane], x.half[2][lane]});
    if (size * relative_.ratio() <= y.reach) {
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
  if (size <= x.reach * relative_.ratio()) {
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

void PairWalk::gather_nodes(WalkRound& round) {
  PairList& codes = memory_.codes;
  const std::size_t taken = std::min(group_of(opened_), codes.size());
  const std::uint32_t order = nearest_first_ && opened_ < kOrdered ? 1 : 0;
  opened_ += taken;
  codes.drop(taken);
  const PoseNumbers& numbers = relative_.numbers();
  NodeTask* next = round.nodes.data() + round.node_count;
  // What was on top comes last, so that its children end on top.
  for (std::size_t i = codes.size(); i < codes.size() + taken; ++i) {
    const PlacePair pair = codes.at(i);
    const WideNode& x = nodes_x_[pair.x >> kIndexShift];
    const WideNode& y = nodes_y_[pair.y >> kIndexShift];
    const float size_x = x.reach * numbers.ratio;
    if (size_x > kSimilar * y.reach || y.reach > kSimilar * size_x) {
      if (!is_lane(pair.x | pair.y)) {
        const std::uint32_t count = size_x > y.reach ? x.count : y.count;
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

void PairWalk::append(std::span<const NodeTask> tasks) {
  PairList& codes = memory_.codes;
  PairList& blocks = memory_.blocks;
  constexpr std::size_t kMost = 16;
  codes.reserve(kMost * (tasks.size() + 1));
  blocks.reserve(kMost * (tasks.size() + 1));
  PairSink sink{codes.end_x(), codes.end_y(), blocks.end_x(), blocks.end_y()};
  kernels_.append(tasks.data(), tasks.size(), sink);
  codes.add(sink.codes);
  blocks.add(sink.blocks);
  const std::size_t next = std::min(group_of(opened_), codes.size());
  for (std::size_t i = codes.size() - next; i < codes.size(); ++i) {
    const PlacePair pair = codes.at(i);
    fetch(nodes_x_[pair.x >> kIndexShift]);
    fetch(nodes_y_[pair.y >> kIndexShift]);
  }
  for (std::size_t i = blocks.size() - sink.blocks; i < blocks.size(); ++i) {
    const PlacePair pair = blocks.at(i);
    fetch(block_x(pair.x));
    fetch(block_y(pair.y));
  }
}

bool PairWalk::gather(WalkRound& round) {
  node_begin_ = round.node_count;
  larger_begin_ = round.larger_count;
  block_begin_ = round.block_count;
  scanned_ = 0;
  if (!memory_.blocks.empty()) {
    gather_blocks(round);
  } else if (!memory_.codes.empty()) {
    gather_nodes(round);
  } else {
    return false;
  }
  node_count_ = round.node_count - node_begin_;
  larger_count_ = round.larger_count - larger_begin_;
  block_count_ = round.block_count - block_begin_;
  return true;
}

void PairWalk::test(const Kernels& kernels, WalkRound& round) {
  kernels.test_nodes(round.nodes.data(), round.node_count);
  kernels.test_larger(round.larger.data(), round.larger_count);
  kernels.test_slabs(round.blocks.data(), round.block_count);
}

bool PairWalk::take_up(const WalkRound& round, Collector& collector, Watch& watch) {
  for (std::size_t i = 0; i < larger_count_; ++i) {
    push(round.larger[larger_begin_ + i]);
  }
  if (node_count_ != 0) {
    append(std::span(round.nodes).subspan(node_begin_, node_count_));
  }
  const bool last = memory_.codes.empty() && memory_.blocks.empty();
  if ((block_count_ != 0 || last) &&
      leaves_.decide(std::span(round.blocks).subspan(block_begin_, block_count_), last, collector,
                     cost_)) {
    return false;
  }
  return !watch.spend(1 + node_count_ + larger_count_ + 2 * block_count_ + scanned_);
}

void PairWalk::run(Collector& collector, Watch& watch) {
  WalkRound round;
  while (gather(round)) {
    test(kernels_, round);
    if (!take_up(round, collector, watch)) {
      return;
    }
    round.clear();
  }
}

std::vector<PlacePair> PairWalk::frontier(std::size_t enough) {
  start();
  std::vector<PlacePair> level;
  for (std::size_t i = 0; i < memory_.codes.size(); ++i) {
    level.push_back(memory_.codes.at(i));
  }
  std::vector<PlacePair> next;
  bool opened = true;
  while (opened && level.size() < enough) {
    next.clear();
    opened = false;
    for (const PlacePair& pair : level) {
      if (pair.blocks()) {
        next.push_back(pair);
        continue;
      }
      start(pair);
      WalkRound round;
      gather_nodes(round);
      test(kernels_, round);
      for (std::size_t i = 0; i < round.larger_count; ++i) {
        push(round.larger[i]);
      }
      append(std::span(round.nodes).first(round.node_count));
      for (const PairList* list : {&memory_.blocks, &memory_.codes}) {
        for (std::size_t i = 0; i < list->size(); ++i) {
          next.push_back(list->at(i));
        }
      }
      opened = true;
    }
    level.swap(next);
  }
  return level;
}

PlacePair PairWalk::take_blocks() {
  constexpr std::uint32_t kRun = WideNode::kRunBit;
  const PlacePair pair = memory_.blocks.pop();
  const PlacePair here{pair.x & ~kRun, pair.y & ~kRun};
  // Row by row: only the head of a row, whose y is still a run too, goes on to the next row.
  if ((pair.x & kRun) != 0 && block_x(here.x).following > 0) {
    memory_.blocks.push({pair.x + 1, pair.y});
  }
  if ((pair.y & kRun) != 0 && block_y(here.y).following > 0) {
    memory_.blocks.push({here.x, pair.y + 1});
  }
  return here;
}

void PairWalk::gather_blocks(WalkRound& round) {
  for (std::size_t i = 0; i < WalkRound::kEach && !memory_.blocks.empty(); ++i) {
    const PlacePair pair = take_blocks();
    BlockTask& task = round.blocks[round.block_count++];
    task.pose = &relative_.numbers();
    task.x = &block_x(pair.x);
    task.y = &block_y(pair.y);
    cost_.node_tests += task.x->count + task.y->count;
  }
}

}  // namespace soms::detail
