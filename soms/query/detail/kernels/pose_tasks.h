/// \file
/// Relative poses that kernels find several at a time.
#pragma once

#include "soms/base/double_limits.h"
#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/tree/layout/detail/ground_plan.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// A tree x that moves, whatever its pose (relative_pose.h).
struct MovedNumbers {
  Vec3 origin;  ///< of the tree, in the mesh's units
  Vec3 far;     ///< largest magnitudes of its bounds' coordinates
  Vec3 half;    ///< half sides of its bounds
};

/// A tree y at a pose, in whose axes x is seen.
struct ReferenceNumbers {
  bool rotated = false;  ///< false: the rotation is the identity, to the bit
  std::array<std::array<double, 3>, 3> inverse;  ///< of the rotation, as computed
  Vec3 origin;                                   ///< of the tree, moved
  Vec3 half;                                     ///< half sides of its bounds
  double residual = 0;                           ///< largest entry of |inverse * rotation - I|
  double extent = 0;  ///< largest moved coordinate, bounded; V of the proof is a sum of two
};

/// W of relative_pose.h: for each unit of V, and what underflow adds. Its sums are checked in
/// relative_pose.cpp.
inline constexpr double kSlackOfRounding = 192;  ///< in units of 2^-53
inline constexpr double kSlackOfResidual = 12;   ///< in units of the residual
inline constexpr double kSlackOfUnderflow = 0x1p-1064;

/// In units of the layout: what is added to W for lengths that underflow, and the most that it may
/// be. Beyond that rounding outweighs a body a thousandfold and more.
inline constexpr double kSlackOfLengths = 0x1p-100;
inline constexpr double kMostSlackOfPoses = 0x1p40;

/// What x's box of all needs to know of y.
struct BoxNumbers {
  /// Margin for each unit of the box's size and of a node's (single_box_descent.h).
  static constexpr float kMargin = 0x1p-19F;

  double scale = 1;                          ///< of the layout
  const layout::GroundPlan* plan = nullptr;  ///< if y has one
};

/// Relative poses of several poses of x, and its box of all at each: a row for each number.
struct alignas(64) RelativePoses {
  static constexpr std::size_t kMost = 16;
  using Row = std::array<double, kMost>;
  using FloatRow = std::array<float, kMost>;

  std::array<Row, 9> matrix;     ///< N
  std::array<Row, 3> shift;      ///< D
  std::array<Row, 3> half_seen;  ///< half sides of x's bounds along y's axes
  Row scale;                     ///< PoseNumbers::scale
  FloatRow slack;                ///< PoseNumbers::slack
  Row residual;                  ///< of the reference frame; kernels leave it alone
  std::array<FloatRow, 3> half;  ///< SingleBox::half, and sum
  FloatRow sum;
  std::array<Row, 2> from;  ///< SingleBox::place, if y has a ground plan, not yet cut to integers
  std::array<Row, 2> to;
  Row lower;
  Row upper;
  std::uint32_t apart;  ///< poses at which the bounds are surely apart
};

}  // namespace soms::detail
