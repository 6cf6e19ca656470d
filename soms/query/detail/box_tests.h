/// \file
/// Boxes of two trees against each other on six axes: the three of each node's frame. A bit that is
/// not set means surely apart; the margins are proved in relative_pose.h.
#pragma once

#include "soms/query/detail/lanes.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace soms::detail {

/// One box of a node: a lane, or all lanes together.
struct OneBox {
  std::array<float, 3> center;
  std::array<float, 3> half;

  [[nodiscard]] static OneBox lane(const WideNode& node, std::uint32_t k) {
    return {{node.center[0][k], node.center[1][k], node.center[2][k]},
            {node.half[0][k], node.half[1][k], node.half[2][k]}};
  }

  [[nodiscard]] static OneBox whole(const WideNode& node) { return {{0, 0, 0}, node.own_half}; }
};

/// Offset and margin of a pair of nodes.
struct NodePair {
  NodePair(const RelativePose& pose, const WideNode& x, const WideNode& y)
      : offset(pose.offset(x.origin, y.origin)) {
    const float distance = (std::abs(offset[0]) + std::abs(offset[1])) + std::abs(offset[2]);
    margin = pose.relative() * ((x.reach * pose.ratio() + y.reach) + distance) + pose.slack();
  }

  std::array<float, 3> offset;
  float margin;
};

/// A box of x's node against the boxes of y's: bit k for lane k.
[[nodiscard]] std::uint32_t one_against_four(const RelativePose& pose, const WideNode& x,
                                             const OneBox& box, const WideNode& y);

/// The boxes of x's node against a box of y's: bit k for lane k.
[[nodiscard]] std::uint32_t four_against_one(const RelativePose& pose, const WideNode& x,
                                             const WideNode& y, const OneBox& box);

/// All boxes of two nodes: bit 4 r + k for lane k of x and lane (k + r) mod 4 of y.
[[nodiscard]] std::uint32_t four_against_four(const RelativePose& pose, const WideNode& x,
                                              const WideNode& y);

}  // namespace soms::detail
