/// \file
/// The boxes of a node over a stretch of the way.
#pragma once

#include "soms/motion/detail/motion_interval.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// How far points of a box may be off where the box is put.
struct BoxSway {
  double radius;  ///< half its longest diagonal
  double bow;     ///< how far the way may be off its chord
  double give;    ///< with the turn of the box
};

/// The boxes of a node in the frame of the law. Lanes from `count` on are of no size.
struct alignas(64) SweptBoxes {
  static constexpr std::size_t kLanes = WideNode::kWidth;

  using Row = std::array<double, kLanes>;
  using Vectors = std::array<Row, 3>;  ///< axis, lane

  std::size_t count = 0;
  std::array<Vec3, 3> axis;       ///< box edges are along these, which need not be at right angles
  std::array<Vec3, 3> direction;  ///< of the axes, of length 1
  Vectors center = {};
  Vectors change = {};  ///< of the center, from the middle of the stretch to its end
  Vectors half = {};
  Row give = {};  ///< as BoxSway
  Row bow = {};

  /// Half the longest diagonal of a lane.
  [[nodiscard]] double radius(std::size_t lane) const;
};

/// A lane of a vector.
[[nodiscard]] inline Vec3 lane_of(const SweptBoxes::Vectors& rows, std::size_t lane) {
  return {rows[0][lane], rows[1][lane], rows[2][lane]};
}

inline void put_lane(const Vec3& v, std::size_t lane, SweptBoxes::Vectors& rows) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    rows[axis][lane] = v[axis];
  }
}

/// Which boxes of a node: `count` lanes from `first` on, or the box of all of them.
struct BoxChoice {
  bool whole = false;
  std::size_t first = 0;
  std::size_t count = 1;
};

inline constexpr BoxChoice kWholeNode{true, 0, 1};

[[nodiscard]] inline BoxChoice all_lanes(const WideNode& node) {
  return {false, 0, node.count};
}

[[nodiscard]] inline BoxChoice one_lane(std::size_t lane) {
  return {false, lane, 1};
}

/// The chosen boxes, from lane 0 on.
[[nodiscard]] SweptBoxes swept_boxes(const WideTree& tree, const WideNode& node,
                                     const MotionBounds& bounds, const MotionInterval& interval,
                                     const BoxChoice& choice);

/// The same of a body that rests.
[[nodiscard]] SweptBoxes resting_boxes(const WideTree& tree, const WideNode& node, const Pose& pose,
                                       const BoxChoice& choice);

/// Of the box of all lanes, without the rest of it.
[[nodiscard]] BoxSway sway_of_whole(const WideTree& tree, const WideNode& node,
                                    const MotionBounds& bounds, const MotionInterval& interval);

/// Half the longest diagonal of the box of all lanes.
[[nodiscard]] double radius_of_whole(const WideTree& tree, const WideNode& node);

}  // namespace soms::detail
