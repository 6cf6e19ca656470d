/// \file
/// Where the law of a motion puts a point, by long doubles.
#pragma once

#include "soms/motion/rigid_motion.h"

#include <array>
#include <cstddef>

namespace soms::test {

using Far3 = std::array<long double, 3>;

[[nodiscard]] inline Far3 place_by_law(const RigidMotion& motion, const Vec3& v, long double t) {
  if (motion.straight()) {
    const Vec3 start = motion.start().apply(v);
    return {start.x + t * motion.by().x, start.y + t * motion.by().y, start.z + t * motion.by().z};
  }
  std::array<long double, 4> q{};
  long double squared = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const long double from = motion.from()[k];
    q[k] = from + t * (motion.to()[k] - from);
    squared += q[k] * q[k];
  }
  const auto [w, x, y, z] = q;
  const std::array<Far3, 3> rotation{
      {{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
       {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
       {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
  Far3 place{};
  for (std::size_t i = 0; i < 3; ++i) {
    const long double from = motion.pivot_from()[i];
    place[i] = from + t * (motion.pivot_to()[i] - from);
    for (std::size_t j = 0; j < 3; ++j) {
      place[i] += rotation[i][j] / squared *
                  (static_cast<long double>(v[j]) - static_cast<long double>(motion.pivot()[j]));
    }
  }
  return place;
}

}  // namespace soms::test
