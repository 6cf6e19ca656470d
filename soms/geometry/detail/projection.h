/// \file
/// Coordinates that are left when one is dropped.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/orientation.h"

namespace soms::detail {

/// First coordinate of `p` in a coordinate plane.
[[nodiscard]] constexpr double first_coordinate(const Vec3& p, Projection plane) {
  return plane == Projection::xy ? p.x : plane == Projection::yz ? p.y : p.z;
}

/// Second coordinate of `p` in a coordinate plane.
[[nodiscard]] constexpr double second_coordinate(const Vec3& p, Projection plane) {
  return plane == Projection::xy ? p.y : plane == Projection::yz ? p.z : p.x;
}

}  // namespace soms::detail
