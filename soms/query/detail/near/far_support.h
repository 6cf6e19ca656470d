/// \file
/// How far boxes reach along a direction: what bounds of far bodies and of far points are made of.
/// near_pose.h has the proof.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/query/detail/engine/pair_frame.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>

namespace soms::detail {

/// `w` along the axes of a mesh that a pose moves, then along those of a node.
[[nodiscard]] Vec3 seen_in_doubles(const Pose& pose, const Vec3& w, const layout::Axes& axes);

/// The same, rounded to float.
[[nodiscard]] std::array<float, 3> seen(const Pose& pose, const Vec3& w, const layout::Axes& axes);

/// Where a pose moves a point to that is given relative to a tree's origin.
[[nodiscard]] Vec3 place_of(const PosedShape& side, const std::array<double, 3>& origin);

/// Least values of `sign` times boxes' points along `w`.
[[nodiscard]] std::array<float, WideNode::kWidth> supports(const WideNode& node,
                                                           const std::array<float, 3>& w,
                                                           float sign);

/// Margins of far bodies and points, in units of V, and of sums over their boxes, in units of their
/// radii. Largest seen: 0.097 of both together.
inline constexpr double kFarRounding = 256 * 0x1p-53;
inline constexpr double kFarBoxes = 0x1p-19;
inline constexpr double kFarUnderflow = 0x1p-1064;  // a length in the world
static_assert((23 + 12 * 3.5) * 0x1p-53 < kFarRounding);

}  // namespace soms::detail
