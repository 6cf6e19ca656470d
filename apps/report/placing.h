/// \file
/// Small helps for placing things where they are drawn. Their rounding decides nothing.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"

#include <array>

namespace soms::report {

[[nodiscard]] double length(const Vec3& v);

/// A box around a moved box.
[[nodiscard]] Box moved(const Box& box, const Pose& pose);

[[nodiscard]] Triangle moved(const Triangle& t, const Pose& pose);

/// Two points of the set that two triangles share, as far apart as its corners are; the middles of
/// the triangles where they share nothing.
[[nodiscard]] std::array<Vec3, 2> crossing_line(const Triangle& a, const Triangle& b);

/// The point that `pose` moves to `at`, but for rounding.
[[nodiscard]] Vec3 moved_back(const Vec3& at, const Pose& pose);

/// The turning of a pose as a quaternion x, y, z, w.
/// \source Shepperd 1978: the largest component first, so that no small number divides.
[[nodiscard]] std::array<double, 4> quaternion(const Pose& pose);

}  // namespace soms::report
