/// \file
/// Places on the Earth, by the ellipsoid of WGS 84.
#pragma once

#include "soms/base/vector.h"

namespace soms::detail {

/// Half the equatorial diameter, in meters.
inline constexpr double kEquatorialRadius = 6378137;

/// A place: radians east and north, and meters above the ellipsoid.
struct GeodeticPlace {
  double longitude = 0;
  double latitude = 0;
  double height = 0;
};

/// The place of a point in Earth-centered coordinates, in meters; right to a millimeter within
/// 100 km of the ellipsoid.
/// \source Bowring, Transformation from spatial to geographical coordinates, Survey Review 23
///         (1976), pages 323 to 327
[[nodiscard]] GeodeticPlace geodetic_place(const Vec3& point);

}  // namespace soms::detail
