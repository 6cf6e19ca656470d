/// \file
/// The first contact of a triangle that shifts with one that rests, in whole numbers.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/exact_ray.h"

#include <optional>

namespace soms::detail {

/// The least t in [0, 1] at which `moving`, shifted by t * `by`, shares a point with `resting`,
/// both closed; nothing if there is none.
///
/// At that time a corner of one lies in the other, or two edges cross: that is so of coplanar
/// triangles that overlap, and others that touch for the first time are parted by a plane through
/// such features. Seen from the moving triangle, t `by` lies in the difference of two features: a
/// triangle less a corner, or the parallelogram of two edges. Each is met by a ray from the origin.
/// \pre They share no point at t = 0. Coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] std::optional<RayTime> exact_sweep(const Triangle& moving, const Triangle& resting,
                                                 const Vec3& by);

}  // namespace soms::detail
