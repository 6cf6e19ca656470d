/// \file
/// The default traversal: two wide trees walked together, with lists of pairs that grow.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/relative_pose.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// A pair of places in two trees: codes of which one at least is a node (see NodeTask), or words of
/// WideNode::child that are leaves both.
struct PlacePair {
  std::uint32_t x;
  std::uint32_t y;

  [[nodiscard]] bool blocks() const { return (x & WideNode::kLeafBit) != 0; }
};

/// A stack of pairs that allocates only when it outgrows what it has.
class PairList {
 public:
  PairList() = default;
  PairList(const PairList&) = delete;
  PairList& operator=(const PairList&) = delete;
  ~PairList() = default;

  [[nodiscard]] bool empty() const { return size_ == 0; }

  [[nodiscard]] std::size_t size() const { return size_; }

  void clear() { size_ = 0; }

  void push(const PlacePair& pair) {
    reserve(1);
    x_[size_] = pair.x;
    y_[size_++] = pair.y;
  }

  PlacePair pop() {
    --size_;
    return {x_[size_], y_[size_]};
  }

  /// Takes the last `count` pairs off; `at` still has them until something is added.
  void drop(std::size_t count) { size_ -= count; }

  [[nodiscard]] PlacePair at(std::size_t i) const { return {x_[i], y_[i]}; }

  /// Makes room for `more` pairs at `end_x` and `end_y`, which `add` then counts.
  void reserve(std::size_t more) {
    if (size_ + more > capacity_) {
      grow(size_ + more);
    }
  }

  [[nodiscard]] std::uint32_t* end_x() { return x_ + size_; }

  [[nodiscard]] std::uint32_t* end_y() { return y_ + size_; }

  void add(std::size_t count) { size_ += count; }

 private:
  static constexpr std::size_t kNear = 256;

  void grow(std::size_t least);

  std::array<std::uint32_t, 2 * kNear> near_;
  std::vector<std::uint32_t> far_;
  std::uint32_t* x_ = near_.data();
  std::uint32_t* y_ = near_.data() + kNear;
  std::size_t size_ = 0;
  std::size_t capacity_ = kNear;
};

/// Pairs still to be opened or decided.
struct WalkMemory {
  PairList codes;
  PairList blocks;

  void clear() {
    codes.clear();
    blocks.clear();
  }
};

/// What walks have in hand: tests of several pairs, of one walk or of several, are made together,
/// as one alone waits for memory and for its own results.
struct WalkRound {
  static constexpr std::size_t kWalks = 4;  ///< most walks of a round
  static constexpr std::size_t kEach = 8;   ///< most tests of each kind of a walk

  std::array<NodeTask, kWalks * kEach> nodes;   // both nodes are opened
  std::array<NodeTask, kWalks * kEach> larger;  // the larger one is
  std::array<BlockTask, kWalks * kEach> blocks;
  std::size_t node_count = 0;
  std::size_t larger_count = 0;
  std::size_t block_count = 0;

  void clear() {
    node_count = 0;
    larger_count = 0;
    block_count = 0;
  }
};

/// One query. Sides x and y are the caller's a and b, or b and a when `swapped`.
class PairWalk {
 public:
  PairWalk(const RelativePose& relative, const WalkSide& x, const WalkSide& y, bool swapped,
           OverlapMode mode, WalkMemory& memory);

  /// Begins at the roots.
  void start();

  /// Begins at a pair of places.
  void start(const PlacePair& from);

  /// Puts the next tests into the round; false when the walk is over.
  [[nodiscard]] bool gather(WalkRound& round);

  /// Takes up what the tests of the round said; false when the walk is over.
  [[nodiscard]] bool take_up(const WalkRound& round, Collector& collector, Watch& watch);

  /// Makes the tests of a round.
  static void test(const Kernels& kernels, WalkRound& round);

  /// Walks until the end, alone.
  void run(Collector& collector, Watch& watch);

  /// Opens pairs in order, level by level, until there are `enough` or only blocks are left: the
  /// same pairs whatever the number of threads.
  [[nodiscard]] std::vector<PlacePair> frontier(std::size_t enough);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  [[nodiscard]] const TriangleBlock& block_x(std::uint32_t word) const {
    return blocks_x_[word & (WideNode::kMost - 1)];
  }

  [[nodiscard]] const TriangleBlock& block_y(std::uint32_t word) const {
    return blocks_y_[word & (WideNode::kMost - 1)];
  }

  void gather_nodes(WalkRound& round);
  void gather_blocks(WalkRound& round);

  /// Appends what met to the lists.
  void append(std::span<const NodeTask> tasks);

  /// Pushes the lanes of the larger node that met.
  void push(const NodeTask& task);

  /// False if a leaf that is larger than a node has no triangle near it.
  [[nodiscard]] bool large_leaf_meets(const PlacePair& pair, const WideNode& x, const WideNode& y);

  /// Pops a pair of blocks. Of a run of blocks it gives the first and leaves the rest.
  [[nodiscard]] PlacePair take_blocks();

  const RelativePose& relative_;
  LeafPairs leaves_;
  const WideNode* nodes_x_;
  const WideNode* nodes_y_;
  const TriangleBlock* blocks_x_;
  const TriangleBlock* blocks_y_;
  const Kernels& kernels_;
  bool nearest_first_;
  WalkMemory& memory_;
  Cost cost_;
  std::size_t opened_ = 0;      // pairs so far
  std::size_t node_begin_ = 0;  // this walk's tests of the round
  std::size_t node_count_ = 0;
  std::size_t larger_begin_ = 0;
  std::size_t larger_count_ = 0;
  std::size_t block_begin_ = 0;
  std::size_t block_count_ = 0;
};

}  // namespace soms::detail
