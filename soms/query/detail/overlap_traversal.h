/// \file
/// The default traversal: two trees traversed together, with lists of pairs that grow.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/large_leaf.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/query/detail/self/self_frame.h"
#include "soms/query/detail/single_box_descent.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Pairs still to be descended or decided.
struct TraversalMemory {
  PairList node_ids;
  PairList blocks;
  LeafQueue leaves;

  void clear() {
    node_ids.clear();
    blocks.clear();
    leaves.clear();
  }
};

/// What traversals have in hand: tests of several pairs, of one traversal or of several, are made
/// together, as one alone waits for memory and for its own results.
struct TraversalRound {
  static constexpr std::size_t kTraversals = 4;  ///< most traversals of a round
  static constexpr std::size_t kEach = 8;        ///< most tests of each kind of a traversal

  std::array<NodeTask, kTraversals * kEach> nodes;   // both nodes are descended
  std::array<NodeTask, kTraversals * kEach> larger;  // the larger one is
  std::array<BlockTask, kTraversals * kEach> blocks;
  std::size_t node_count = 0;
  std::size_t larger_count = 0;
  std::size_t block_count = 0;

  void clear() {
    node_count = 0;
    larger_count = 0;
    block_count = 0;
  }
};

/// Makes the tests of a round.
void test_round(const Kernels& kernels, TraversalRound& round);

/// What is known from the roots' boxes and a few cells of a height grid.
struct RootTest {
  bool clear = false;  ///< nothing overlaps
  bool alone = false;  ///< x goes down y by itself, as one box
  SingleBox box;       ///< that box
};

/// Tests the roots, which ends most queries of small bodies before anything else is made ready. Not
/// returned, as GroundPlan::place is not.
template <class Source>
void test_roots(const PairFrame& frame, RootTest& roots);

/// One query, of layouts that `Source` reads. With a SelfFrame both trees are one, and each pair of
/// its nodes is met once.
template <class Source, class Frame = PairFrame>
class OverlapTraversal {
 public:
  OverlapTraversal(Frame& frame, OverlapMode mode, TraversalMemory& memory);

  /// Begins at the roots, or below that of y where x is small beside it and y lies in place.
  void start();

  /// The same where the roots have been tested, and are not clear.
  void start(const RootTest& roots);

  /// Begins where `start` would have led to, at that cost (see BatchedRootDescent).
  void start(const PairList& seeds, const Cost& cost);

  /// Begins at a pair of nodes.
  void start(const NodeRefPair& from);

  /// Puts the next tests into the round; false when the traversal is over.
  [[nodiscard]] bool gather(TraversalRound& round);

  /// Takes up what the tests of the round said; false when the traversal is over.
  [[nodiscard]] bool take_up(const TraversalRound& round, Collector& collector, Limit& limit);

  /// Traverses until the end, alone.
  void run(Collector& collector, Limit& limit);

  /// Descends pairs in order, level by level, until there are `enough` or only blocks are left: the
  /// same pairs whatever the number of threads.
  [[nodiscard]] std::vector<NodeRefPair> frontier(std::size_t enough);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  void gather_nodes(TraversalRound& round);
  void gather_blocks(TraversalRound& round);

  /// The least pair of triangles that may lie below a pair of nodes.
  [[nodiscard]] TrianglePair least_below(const NodeRefPair& pair) const {
    return frame_.in_callers_order(least_x_[index_of(pair.x)], least_y_[index_of(pair.y)]);
  }

  /// Puts the pairs of nodes from `begin` on in order, that of the least triangles on top.
  void order_by_least(std::size_t begin);

  /// Drops pairs of nodes on top that have nothing which the collector wants.
  void drop_unwanted(const Collector& collector);

  /// Appends what met to the lists.
  void append(std::span<const NodeTask> tasks);

  /// Pushes the lanes of the larger node that met.
  void push(const NodeTask& task);

  /// Pops a pair of blocks. Of a run of blocks it gives the first and leaves the rest.
  [[nodiscard]] NodeRefPair take_blocks();

  const Frame& frame_;
  RelativePose& relative_;
  LeafPairs<Frame> leaves_;
  Source x_;
  Source y_;
  LargeLeaf<Source> large_leaf_;
  const Kernels& kernels_;
  std::span<const TriangleId> least_x_;
  std::span<const TriangleId> least_y_;
  OverlapMode mode_;
  TraversalMemory& memory_;
  Cost cost_;
  std::size_t descended_ = 0;   // pairs so far
  std::size_t node_begin_ = 0;  // this traversal's tests of the round
  std::size_t node_count_ = 0;
  std::size_t larger_begin_ = 0;
  std::size_t larger_count_ = 0;
  std::size_t block_begin_ = 0;
  std::size_t block_count_ = 0;
};

extern template class OverlapTraversal<WideSource>;
extern template class OverlapTraversal<CompactSource>;
extern template class OverlapTraversal<WideSource, SelfFrame>;
extern template class OverlapTraversal<CompactSource, SelfFrame>;

}  // namespace soms::detail
