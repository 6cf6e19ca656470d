/// \file
/// A leaf beside a smaller node of the other tree: the leaf's triangles against the node's box.
/// Boxes of large triangles say little; their planes say more.
#pragma once

#include "soms/query/answer.h"
#include "soms/query/detail/block_against_box.h"
#include "soms/query/detail/engine/node_id.h"
#include "soms/query/detail/engine/pair_list.h"
#include "soms/query/detail/relative_pose.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace soms::detail {

/// Tests leaves of one pair of trees.
template <class Source>
class LargeLeaf {
 public:
  LargeLeaf(const RelativePose& relative, Source& x, Source& y)
      : relative_(relative), x_(x), y_(y) {}

  LargeLeaf(const LargeLeaf&) = delete;
  LargeLeaf& operator=(const LargeLeaf&) = delete;
  ~LargeLeaf() = default;

  /// False only if the leaf of `pair` is larger than the node and all of its triangles are more
  /// than `reach`, in units of y, from what is in the node: 0, or a limit of nearness
  /// (near_pose.h). `x` and `y` are the pair's nodes. \pre One side of the pair is a lane with a
  /// leaf.
  [[nodiscard]] bool meets(const NodeRefPair& pair, const WideNode& x, const WideNode& y,
                           float reach, Cost& cost) {
    BoxRelation relation;
    if (is_lane(pair.x)) {
      const std::uint32_t lane = lane_of(pair.x);
      return half_of(x, lane) * relative_.ratio() <= y.l1_radius ||
             any_block(x_, x.child[lane], cost, [&](const TriangleBlock& block) {
               relative_.relate(block, y, relation);
               return box_against_x(relation, block, y.own_half(), reach) != 0;
             });
    }
    const std::uint32_t lane = lane_of(pair.y);
    return half_of(y, lane) <= x.l1_radius * relative_.ratio() ||
           any_block(y_, y.child[lane], cost, [&](const TriangleBlock& block) {
             relative_.relate(x, block, relation);
             return box_against_y(relation, x.own_half(), block, reach) != 0;
           });
  }

  /// Blocks looked at since the last call.
  [[nodiscard]] std::size_t take_scanned() { return std::exchange(scanned_, 0); }

 private:
  /// Half the longest side of a lane's box.
  [[nodiscard]] static float half_of(const WideNode& node, std::uint32_t lane) {
    return std::max({node.half[0][lane], node.half[1][lane], node.half[2][lane]});
  }

  /// Whether `meets` holds for a block of the leaf that begins with `token`.
  template <class Meets>
  [[nodiscard]] bool any_block(Source& source, std::uint32_t token, Cost& cost,
                               const Meets& meets) {
    for (;; token = source.next(token)) {
      const TriangleBlock& block = source.block(token);
      cost.node_tests += block.count;
      ++scanned_;
      if (meets(block)) {
        return true;
      }
      if (block.following == 0) {
        return false;
      }
    }
  }

  const RelativePose& relative_;
  Source& x_;
  Source& y_;
  std::size_t scanned_ = 0;
};

}  // namespace soms::detail
