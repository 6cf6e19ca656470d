/// \file
/// The traversal of queries of a point: one wide tree, the nearest boxes first.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/engine/block_source.h"
#include "soms/query/detail/engine/limit.h"
#include "soms/query/detail/kernels/kernels.h"
#include "soms/query/detail/near/point_goal.h"
#include "soms/query/detail/near/point_pose.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::detail {

/// A node or leaf that is still to be looked at, with a lower bound of its distance.
struct KeyedNode {
  float key;
  std::uint32_t word;  ///< as in WideNode::child
};

/// A triangle with a lower bound of its distance.
struct PointCandidate {
  float key;
  TriangleId id;

  [[nodiscard]] bool operator<(const PointCandidate& other) const {
    return key < other.key || (key == other.key && id < other.id);
  }
};

/// What a traversal has still to look at.
struct PointMemory {
  std::vector<KeyedNode> nodes;
  std::vector<PointCandidate> candidates;
};

/// One query. Depth first, so that what waits is bounded by the depth of the tree; triangles that
/// floats cannot part from the nearest wait, too, and are decided once there are many.
template <class Source>
class PointTraversal {
 public:
  PointTraversal(const PointFrame& frame, PointPose& pose, PointGoal& goal, PointMemory& memory);

  /// Traverses until the end or until the limit ends it.
  void run(Limit& limit);

  /// Everything that mattered was offered to the goal.
  [[nodiscard]] bool complete() const { return complete_; }

  /// Nothing that was left for want of time, nor what is beyond the goal's bound, is nearer than
  /// this in the world.
  [[nodiscard]] double at_least() const;

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  static constexpr std::size_t kCandidates = 1024;  // kept until they are decided
  static constexpr std::uint64_t kOfferWork = 40;   // a decision of about a microsecond

  void open(const WideNode& node);
  /// False when the limit ends it within a leaf of many blocks.
  [[nodiscard]] bool look_at_leaf(std::uint32_t token, Limit& limit);
  void look_at(const TriangleBlock& block);
  void offer_nearest(const TriangleBlock& block, const PointBlockKeys& keys);
  void offer_all(const TriangleBlock& block, const PointBlockKeys& keys);
  void offer(TriangleId id);
  void settle();

  PointPose& pose_;
  PointGoal& goal_;
  PointMemory& memory_;
  Source source_;
  const Kernels& kernels_;
  Cost cost_;
  float best_estimate_ = std::numeric_limits<float>::infinity();
  std::uint64_t work_ = 0;  // since the limit was last looked at, as it counts
  bool complete_ = false;
};

extern template class PointTraversal<WideSource>;
extern template class PointTraversal<CompactSource>;

}  // namespace soms::detail
