#include "soms/io/detail/cityjson/geodesy.h"

#include <cmath>

namespace soms::detail {

GeodeticPlace geodetic_place(const Vec3& point) {
  constexpr double kFlattening = 1 / 298.257223563;
  constexpr double kPolarRadius = kEquatorialRadius * (1 - kFlattening);
  constexpr double kFirst = kFlattening * (2 - kFlattening);  // eccentricities, squared
  constexpr double kSecond = kFirst / (1 - kFirst);
  const double across = std::hypot(point.x, point.y);
  double latitude = 0;
  // The first guess is that of the surface; a second round makes up for heights.
  double reduced = std::atan2(point.z * kEquatorialRadius, across * kPolarRadius);
  for (int round = 0; round < 2; ++round) {
    const double s = std::sin(reduced);
    const double c = std::cos(reduced);
    latitude = std::atan2(point.z + kSecond * kPolarRadius * (s * s * s),
                          across - kFirst * kEquatorialRadius * (c * c * c));
    reduced = std::atan2((1 - kFlattening) * std::sin(latitude), std::cos(latitude));
  }
  const double s = std::sin(latitude);
  return {std::atan2(point.y, point.x), latitude,
          (across * std::cos(latitude) + point.z * s) -
              kEquatorialRadius * std::sqrt(1 - kFirst * (s * s))};
}

}  // namespace soms::detail
