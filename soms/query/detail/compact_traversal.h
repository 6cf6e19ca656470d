/// \file
/// The traversal of compact layouts: nodes and blocks are written out when they are met.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/collector.h"
#include "soms/query/detail/leaf_pairs.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstdint>
#include <vector>

namespace soms::detail {

/// Nodes and blocks of one side, of either layout. Blocks that were written out last are kept, one
/// in each of a few places.
class SideReader {
 public:
  explicit SideReader(const Shape& shape);

  /// Valid until the next call.
  [[nodiscard]] const WideNode& node(std::uint32_t i);

  /// The block that a leaf's token names; valid until another one is requested.
  [[nodiscard]] const TriangleBlock& block(std::uint32_t token);

  /// The token of the next block of the same leaf.
  [[nodiscard]] std::uint32_t next(std::uint32_t token) const {
    return token + (tree_.compact() != nullptr ? TriangleBlock::kWidth : 1);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr std::size_t kKept = 32;

  const WideTree& tree_;
  const Mesh& mesh_;
  WideNode node_;
  std::array<std::uint32_t, kKept> kept_;
  layout::Pages<TriangleBlock> blocks_;
};

/// One query of which one side at least is compact. Sides x and y as for PairTraversal.
class CompactTraversal {
 public:
  CompactTraversal(const RelativePose& relative, const TraversalSide& x, const TraversalSide& y,
                   bool swapped)
      : relative_(relative), leaves_(x, y, swapped, queue_), x_(*x.shape), y_(*y.shape) {}

  /// Traverses until the end.
  void run(Collector& collector, Watch& watch);

  [[nodiscard]] const Cost& cost() const { return cost_; }

 private:
  /// Two nodes, or a node and a lane of one that is a leaf.
  struct Pair {
    std::uint32_t x;
    std::uint32_t y;
  };

  /// Descends a pair; true when the traversal is to stop.
  [[nodiscard]] bool descend(const Pair& pair, Collector& collector, Watch& watch);

  /// False if a leaf that is larger than a node has no triangle near it.
  [[nodiscard]] bool large_leaf_meets(const Pair& pair, const WideNode& x, const WideNode& y);

  /// Decides two leaves block by block; true when the traversal is to stop.
  [[nodiscard]] bool decide(std::uint32_t token_x, std::uint32_t token_y, Collector& collector,
                            Watch& watch);

  const RelativePose& relative_;
  LeafQueue queue_;
  LeafPairs leaves_;
  SideReader x_;
  SideReader y_;
  std::vector<Pair> pending_;
  Cost cost_;
};

}  // namespace soms::detail
