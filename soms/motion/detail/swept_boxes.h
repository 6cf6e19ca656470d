/// \file
/// The boxes of two nodes, one of which moves: when can they meet?
#pragma once

#include "soms/motion/detail/motion_interval.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// The boxes of a node in world, over a stretch of the way.
struct SweptBoxes {
  static constexpr std::size_t kLanes = WideNode::kWidth;

  std::size_t count = 0;
  std::array<Vec3, 3> axis;       ///< box edges are along these, which need not be at right angles
  std::array<Vec3, 3> direction;  ///< of the axes, of length 1
  std::array<Vec3, kLanes> center;
  std::array<Vec3, kLanes> change;  ///< of the center, from the middle of the stretch to its end
  std::array<std::array<double, 3>, kLanes> half;
  std::array<double, kLanes> give;  ///< how far points may be off their box

  /// Half the longest diagonal of a lane.
  [[nodiscard]] double radius(std::size_t lane) const;
};

/// All lanes of a node or, with `whole`, the box of all of them as one lane.
[[nodiscard]] SweptBoxes swept_boxes(const WideTree& tree, const WideNode& node,
                                     const MotionBounds& bounds, const MotionInterval& interval,
                                     bool whole);

/// The same of a body that rests.
[[nodiscard]] SweptBoxes resting_boxes(const WideTree& tree, const WideNode& node, const Pose& pose,
                                       bool whole);

/// Windows of the pairs of lanes, 4 * lane of x + lane of y.
using LaneWindows = std::array<TimeWindow, 16>;

/// \param margin As MotionBounds::box_margin
void find_windows(const SweptBoxes& x, const SweptBoxes& y, double margin, LaneWindows& windows);

}  // namespace soms::detail
