/// \file
/// How movers go through a scene, frame by frame.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/generate/city.h"

#include <cstdint>
#include <vector>

namespace soms {

/// A polyline that a mover follows at constant speed, heading along it, and starts again at its end
/// (a closed route goes round; an open one is driven to and fro).
struct Route {
  std::vector<Vec3> points;
  bool closed = false;
  double start = 0;  ///< metres along the route at time 0
  double speed = 0;  ///< metres a second

  /// Pose at a time in seconds: +x of the mover along the route, z up.
  [[nodiscard]] Pose at(double seconds) const;
};

/// A drive of a mover along the streets of a city, following the ground. `clearance` is the height
/// of the mover's origin above the ground. Deterministic in `seed`.
[[nodiscard]] Route street_route(const City& city, std::uint64_t seed, double speed,
                                 double clearance);

/// A flight of a drone over and between the buildings.
[[nodiscard]] Route flight_route(const City& city, std::uint64_t seed, double speed, double lowest,
                                 double highest);

/// A straight horizontal line to and fro through `scene` at the height of `start`.
[[nodiscard]] Route straight_route(const Box& scene, const Vec3& start, std::uint64_t seed,
                                   double speed);

}  // namespace soms
