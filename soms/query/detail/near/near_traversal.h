/// \file
/// The traversal of queries of nearness: two wide trees together, the nearest pairs first.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/large_leaf.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/near/keyed_pairs.h"
#include "soms/query/detail/near/near_goal.h"
#include "soms/query/detail/near/near_pose.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace soms::detail {

/// A pair of triangles of x and y, with a lower bound of its distance.
struct NearCandidate {
  float key;
  TrianglePair ids;

  [[nodiscard]] bool operator<(const NearCandidate& other) const {
    return key < other.key || (key == other.key && ids < other.ids);
  }
};

/// What a traversal has still to look at.
struct NearMemory {
  KeyedPairs pairs;
  PairList stack;  // of a single box (single_box_descent.h), and what it may meet
  PairList seeds;
  std::vector<NearCandidate> candidates;
  LeafQueue leaves;
};

/// One query; the same steps from either source.
template <class Source>
class NearTraversal {
 public:
  NearTraversal(const PairFrame& frame, NearPose& pose, NearGoal& goal, NearMemory& memory);

  /// Begins at the roots, or, where it is known what is near, below that of y.
  void start();

  /// Begins, as a part of `whole`, at pairs that it gave away. \pre whole.sorted()
  void start_part(const NearTraversal& whole, std::span<const KeyedPair> pairs);

  /// Traverses until the end, until the limit ends it, or for so many steps; true unless steps are
  /// left to be made.
  [[nodiscard]] bool run(Limit& limit, std::uint64_t steps);

  /// Everything that mattered was offered to the goal.
  [[nodiscard]] bool complete() const { return complete_; }

  /// Gives away up to `count` of the nearest pairs. \pre sorted()
  void give(std::size_t count, std::vector<KeyedPair>& pairs);

  /// Offers the goal what waits to be decided, after a part's `run` that time did not end.
  void settle_part() { static_cast<void>(settle()); }

  /// Ends a traversal that has no pairs left.
  void finish();

  /// Takes what a part found and what it left; true when the query is over.
  [[nodiscard]] bool take(const NearTraversal& part);

  /// A distance is known, and pairs wait by their distance.
  [[nodiscard]] bool sorted() const { return memory_.pairs.sorted(); }

  /// Nothing that was left for want of time, nor what is beyond the goal's bound, is nearer than
  /// this in the world. \cost O(n) in what is left.
  [[nodiscard]] double at_least() const;

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  /// Pairs of nodes looked at together: as many as a source can keep.
  static constexpr std::size_t kGroup = Source::kInPlace ? 4 : 1;
  static constexpr std::size_t kCandidates = 1024;  // kept until they are decided

  /// Nodes whose lanes are paired, and the ids that they come from.
  struct Opening {
    NodeRefPair from;
    bool only_x = false;  // y is not descended
    bool only_y = false;
    WideNode box = {};  // the box of all lanes of the node that is not
  };

  void sort();

  /// Looks at the next pairs; false when the traversal is over.
  [[nodiscard]] bool step(Limit& limit);

  /// Has the children of a pair bounded next, unless it is a leaf out of reach of a smaller node.
  void open(const NodeRefPair& pair);
  void push_children(std::size_t i);

  /// True when the query is over; false, too, when the limit ends it.
  [[nodiscard]] bool look_at_leaves(const NodeRefPair& leaves, Limit& limit);
  [[nodiscard]] bool look_at_blocks(const TriangleBlock& x, const TriangleBlock& y);
  [[nodiscard]] bool empty_queue();
  [[nodiscard]] bool look_at(const PairGaps& gaps, std::size_t begin, std::size_t count);
  /// Triangles are parted next along the line between those of the pair that seems nearest.
  void turn_filter(const PairGaps& gaps, std::size_t begin, std::size_t count);
  [[nodiscard]] bool look_at_far(const TriangleBlock& x, const TriangleBlock& y);
  [[nodiscard]] bool offer(const TrianglePair& ids);
  [[nodiscard]] bool keep(const NearCandidate& candidate);
  [[nodiscard]] bool settle();

  const PairFrame* frame_;
  NearPose& pose_;
  NearGoal& goal_;
  NearMemory& memory_;
  Source x_;
  Source y_;
  LargeLeaf<Source> large_leaf_;
  const Kernels& kernels_;
  Cost cost_;
  float unfinished_ = std::numeric_limits<float>::infinity();
  float best_estimate_;
  float turned_to_ = std::numeric_limits<float>::infinity();  // estimate of the filter's pair
  NearFilter filter_ = {0, {0, 0, 0}};
  std::array<NodeTask, kGroup> tasks_;
  std::array<Opening, kGroup> openings_;
  std::array<NodeKeys, kGroup> keys_;
  std::size_t task_count_ = 0;
  bool complete_ = false;
};

extern template class NearTraversal<WideSource>;
extern template class NearTraversal<CompactSource>;

}  // namespace soms::detail
