/// \file
/// The plane that a polygon is seen in.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/orientation.h"

#include <cstddef>
#include <span>

namespace soms::detail {

/// A coordinate plane, and the side that it is seen from.
struct PolygonPlane {
  Projection projection = Projection::xy;
  std::size_t first_axis = 0;
  std::size_t second_axis = 1;
  bool reversed = false;  ///< the polygon's normal points down the axis that is dropped
};

/// The plane across the largest component of the Newell normal: z, then x, then y where they are
/// equal.
[[nodiscard]] PolygonPlane polygon_plane(std::span<const Vec3> corners);

}  // namespace soms::detail
