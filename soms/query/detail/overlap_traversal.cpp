#include "soms/query/detail/overlap_traversal.h"

#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/single_box_descent.h"

#include <algorithm>
#include <bit>

namespace soms::detail {

namespace {

/// Both nodes are descended while neither is more than this much larger.
constexpr float kSimilar = 2;

/// Pairs descended at once. Where bodies touch, a hit is mostly found within few pairs, and what
/// was descended beside the way to it is lost; a traversal that has gone on for long descends
/// everything anyway, unless the least pair that it has found rules most of it out. What a source
/// writes out does not last for more than one.
template <class Source>
std::size_t group_of(OverlapMode mode, std::size_t descended) {
  if constexpr (Source::kInPlace) {
    return descended < 24 || mode == OverlapMode::first ? 2
           : descended < 48                             ? 4
                                                        : TraversalRound::kEach;
  } else {
    return 1;
  }
}

/// Pairs of blocks tested at once.
template <class Source>
constexpr std::size_t kBlocks = Source::kInPlace ? TraversalRound::kEach : 1;

/// Pairs descended with the nearest of their children first. It halves the way to a hit; a
/// traversal that has found none by then mostly finds none.
constexpr std::size_t kOrdered = 24;

std::size_t lowest(std::uint32_t bits) {
  return static_cast<std::size_t>(std::countr_zero(bits));
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
        const bool lane = is_lane(bits);
        const std::uint32_t lanes = lane ? 1U << lane_of(bits) : (1U << count) - 1;
        entries[count][bits] = {static_cast<std::uint8_t>(lanes),
                                static_cast<std::uint8_t>(lane ? 1 : count)};
      }
    }
  }
};

constexpr CodeTable kCodes;

/// Pairs of a node's lanes of which the second does not come before the first.
constexpr std::uint32_t lanes_not_before() {
  std::uint32_t bits = 0;
  for (std::uint32_t k = 0; k < WideNode::kWidth; ++k) {
    bits |= pairs_of_lanes(1U << k, 0xfU & ~((1U << k) - 1));
  }
  return bits;
}

constexpr std::uint32_t kNotBefore = lanes_not_before();

}  // namespace

template <class Source>
void test_roots(const PairFrame& frame, RootTest& roots) {
  const RelativePose& relative = frame.relative();
  if (relative.apart()) {
    roots.clear = true;
    return;
  }
  if constexpr (Source::kInPlace) {
    const WideTree& y = frame.y().layout();
    relative.single_box(roots.box);
    roots.alone = roots.box.pays(y.nodes()[0]);
    if (roots.alone) {
      roots.box.find_place(y);
      roots.clear = roots.box.clear_of(y);
    }
  }
}

template <class Source, class Frame>
OverlapTraversal<Source, Frame>::OverlapTraversal(Frame& frame, OverlapMode mode,
                                                  TraversalMemory& memory)
    : frame_(frame),
      relative_(frame.relative()),
      leaves_(frame, memory.leaves),
      x_(*frame.x().shape),
      y_(*frame.y().shape),
      large_leaf_(relative_, x_, y_),
      kernels_(kernels()),
      least_x_(frame.x().layout().least_ids()),
      least_y_(frame.y().layout().least_ids()),
      mode_(mode),
      memory_(memory) {
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::start() {
  if constexpr (Frame::kSelf) {
    ++cost_.node_tests;
    memory_.clear();
    memory_.node_ids.push({kRootId, kRootId});
    relative_.prepare();
    return;
  }
  RootTest roots;
  test_roots<Source>(frame_, roots);
  if (roots.clear) {
    ++cost_.node_tests;
    memory_.clear();
  } else {
    start(roots);
  }
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::start(const RootTest& roots) {
  ++cost_.node_tests;
  memory_.clear();
  if (roots.alone) {
    roots.box.descend(frame_.y().layout(), memory_.blocks, memory_.node_ids, cost_);
  } else {
    memory_.node_ids.push({kRootId, kRootId});
  }
  if (!memory_.node_ids.empty()) {
    relative_.prepare();
  }
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::start(const PairList& seeds, const Cost& cost) {
  cost_ = cost;
  memory_.clear();
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    memory_.node_ids.push(seeds.at(i));
  }
  relative_.prepare();
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::start(const NodeRefPair& from) {
  memory_.clear();
  (from.blocks() ? memory_.blocks : memory_.node_ids).push(from);
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::push(const NodeTask& task) {
  const bool descends_x = task.descends_x();
  for (std::uint32_t meet = task.pairs; meet != 0; meet &= meet - 1) {
    const auto lane = static_cast<std::uint32_t>(lowest(meet));
    if (descends_x) {
      const std::uint32_t node_id = child_id(*task.x, task.node_id_x, lane);
      memory_.node_ids.push({node_id, task.node_id_y});
      x_.fetch_node(index_of(node_id));
    } else {
      const std::uint32_t node_id = child_id(*task.y, task.node_id_y, lane);
      memory_.node_ids.push({task.node_id_x, node_id});
      y_.fetch_node(index_of(node_id));
    }
  }
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::gather_nodes(TraversalRound& round) {
  PairList& node_ids = memory_.node_ids;
  const std::size_t taken = std::min(group_of<Source>(mode_, descended_), node_ids.size());
  const std::uint32_t order = mode_ == OverlapMode::any && descended_ < kOrdered ? 1 : 0;
  descended_ += taken;
  node_ids.drop(taken);
  const PoseNumbers& numbers = relative_.numbers();
  NodeTask* next = round.nodes.data() + round.node_count;
  // What was on top comes last, so that its children end on top.
  for (std::size_t i = node_ids.size(); i < node_ids.size() + taken; ++i) {
    const NodeRefPair pair = node_ids.at(i);
    const WideNode& x = x_.node(index_of(pair.x));
    const WideNode& y = y_.node(index_of(pair.y));
    const float size_x = x.l1_radius * numbers.ratio;
    if (size_x > kSimilar * y.l1_radius || y.l1_radius > kSimilar * size_x) {
      if (!is_lane(pair.x | pair.y)) {
        const std::uint32_t count = size_x > y.l1_radius ? x.count : y.count;
        cost_.node_tests += count;
        round.larger[round.larger_count++] = {&numbers,          &x, &y, pair.x, pair.y,
                                              (1U << count) - 1, 0,  0};
        continue;
      }
      if (!large_leaf_.meets(pair, x, y, 0, cost_)) {
        continue;
      }
    } else if (!Source::kInPlace && is_lane(pair.x | pair.y) &&
               !large_leaf_.meets(pair, x, y, 0, cost_)) {
      // To write out what lies below the node would cost more than this look.
      continue;
    }
    const bool alone = Frame::kSelf && pair.x == pair.y;
    const CodeTable::Entry& in_x = kCodes.entries[x.count][pair.x & 7];
    const CodeTable::Entry& in_y = kCodes.entries[y.count][pair.y & 7];
    cost_.node_tests += std::uint64_t{in_x.number} * in_y.number;
    *next++ = {&numbers,
               &x,
               &y,
               without_lane(pair.x),
               without_lane(pair.y),
               kLanePairs.bits[in_x.lanes][in_y.lanes] & (alone ? kNotBefore : 0xffffU),
               order,
               0};
  }
  round.node_count = static_cast<std::size_t>(next - round.nodes.data());
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::append(std::span<const NodeTask> tasks) {
  PairList& node_ids = memory_.node_ids;
  PairList& blocks = memory_.blocks;
  constexpr std::size_t kMost = 16;
  node_ids.reserve(kMost * (tasks.size() + 1));
  blocks.reserve(kMost * (tasks.size() + 1));
  PairSink sink{node_ids.end_x(), node_ids.end_y(), blocks.end_x(), blocks.end_y()};
  kernels_.append(tasks.data(), tasks.size(), sink);
  node_ids.add(sink.node_ids);
  blocks.add(sink.blocks);
  const std::size_t next = std::min(group_of<Source>(mode_, descended_), node_ids.size());
  for (std::size_t i = node_ids.size() - next; i < node_ids.size(); ++i) {
    const NodeRefPair pair = node_ids.at(i);
    x_.fetch_node(index_of(pair.x));
    y_.fetch_node(index_of(pair.y));
  }
  for (std::size_t i = blocks.size() - sink.blocks; i < blocks.size(); ++i) {
    const NodeRefPair pair = blocks.at(i);
    x_.fetch_block(pair.x);
    y_.fetch_block(pair.y);
  }
}

template <class Source, class Frame>
bool OverlapTraversal<Source, Frame>::gather(TraversalRound& round) {
  node_begin_ = round.node_count;
  larger_begin_ = round.larger_count;
  block_begin_ = round.block_count;
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

void test_round(const Kernels& kernels, TraversalRound& round) {
  kernels.test_nodes(round.nodes.data(), round.node_count);
  kernels.test_larger(round.larger.data(), round.larger_count);
  kernels.test_slabs(round.blocks.data(), round.block_count);
}

template <class Source, class Frame>
bool OverlapTraversal<Source, Frame>::take_up(const TraversalRound& round, Collector& collector,
                                              Limit& limit) {
  const std::size_t added = memory_.node_ids.size();
  for (std::size_t i = 0; i < larger_count_; ++i) {
    push(round.larger[larger_begin_ + i]);
  }
  if (node_count_ != 0) {
    append(std::span(round.nodes).subspan(node_begin_, node_count_));
  }
  if (mode_ == OverlapMode::first) {
    order_by_least(added);
    drop_unwanted(collector);
  }
  const bool last = memory_.node_ids.empty() && memory_.blocks.empty();
  if ((block_count_ != 0 || last) &&
      leaves_.decide(std::span(round.blocks).subspan(block_begin_, block_count_), last, collector,
                     cost_)) {
    return false;
  }
  return !limit.spend(1 + node_count_ + larger_count_ + 2 * block_count_ +
                      large_leaf_.take_scanned());
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::order_by_least(std::size_t begin) {
  PairList& node_ids = memory_.node_ids;
  for (std::size_t i = begin + 1; i < node_ids.size(); ++i) {
    const NodeRefPair pair = node_ids.at(i);
    const TrianglePair least = least_below(pair);
    std::size_t at = i;
    for (; at > begin && least_below(node_ids.at(at - 1)) < least; --at) {
      node_ids.set(at, node_ids.at(at - 1));
    }
    node_ids.set(at, pair);
  }
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::drop_unwanted(const Collector& collector) {
  PairList& node_ids = memory_.node_ids;
  while (!node_ids.empty() && !collector.wants(least_below(node_ids.at(node_ids.size() - 1)))) {
    node_ids.drop(1);
  }
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::run(Collector& collector, Limit& limit) {
  TraversalRound round;
  while (gather(round)) {
    test_round(kernels_, round);
    if (!take_up(round, collector, limit)) {
      return;
    }
    round.clear();
  }
}

template <class Source, class Frame>
std::vector<NodeRefPair> OverlapTraversal<Source, Frame>::frontier(std::size_t enough) {
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
      test_round(kernels_, round);
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

template <class Source, class Frame>
NodeRefPair OverlapTraversal<Source, Frame>::take_blocks() {
  constexpr std::uint32_t kRun = WideNode::kRunBit;
  const NodeRefPair pair = memory_.blocks.pop();
  const NodeRefPair here{pair.x & ~kRun, pair.y & ~kRun};
  // Row by row: only the head of a row, whose y is still a run too, goes on to the next row. Of a
  // leaf with itself, a row begins at its own block.
  const bool alone = Frame::kSelf && pair.x == pair.y;
  if ((pair.x & kRun) != 0 && x_.block(here.x).following > 0) {
    memory_.blocks.push({x_.next(pair.x), alone ? y_.next(pair.y) : pair.y});
  }
  if ((pair.y & kRun) != 0 && y_.block(here.y).following > 0) {
    memory_.blocks.push({here.x, y_.next(pair.y)});
  }
  return here;
}

template <class Source, class Frame>
void OverlapTraversal<Source, Frame>::gather_blocks(TraversalRound& round) {
  for (std::size_t i = 0; i < kBlocks<Source> && !memory_.blocks.empty(); ++i) {
    const NodeRefPair pair = take_blocks();
    BlockTask& task = round.blocks[round.block_count++];
    task.pose = &relative_.numbers();
    task.x = &x_.block(pair.x);
    task.y = &y_.block(pair.y);
    cost_.node_tests += task.x->count + task.y->count;
  }
}

template void test_roots<WideSource>(const PairFrame& frame, RootTest& roots);
template void test_roots<CompactSource>(const PairFrame& frame, RootTest& roots);
template class OverlapTraversal<WideSource>;
template class OverlapTraversal<CompactSource>;
template class OverlapTraversal<WideSource, SelfFrame>;
template class OverlapTraversal<CompactSource, SelfFrame>;

}  // namespace soms::detail
