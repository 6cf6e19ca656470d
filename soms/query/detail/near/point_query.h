/// \file
/// What the queries of points share: the check of points, one traversal for a goal, and the order
/// in which a batch is answered.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/query/answer.h"
#include "soms/query/detail/near/near_query.h"
#include "soms/query/detail/near/point_goal.h"
#include "soms/query/detail/near/point_pose.h"
#include "soms/query/detail/near/point_traversal.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::detail {

/// Throws ErrorKind::not_finite or out_of_range unless coordinates are finite and of magnitude at
/// most 2^300. Of several points the first one at fault is named by its index.
void check_point(const Vec3& point);
void check_points(std::span<const Vec3> points);

/// Traverses for a goal. A point takes one thread; `limits` is for its stop.
/// \errors ErrorKind::cancelled.
[[nodiscard]] NearEnd pursue(const PointFrame& frame, const Vec3& point, PointGoal& goal,
                             const Limits& limits, PointMemory& memory);

/// The indices of points in an order in which neighbors are near, along a Morton curve, so that a
/// large tree is read from caches. Empty, for the order that they have, where that does not pay.
[[nodiscard]] std::vector<std::uint32_t> order_of(std::span<const Vec3> points, const Shape& shape);

}  // namespace soms::detail
