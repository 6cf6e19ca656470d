/// \file
/// How movers go through a scene, frame by frame.
#pragma once

#include "soms/base/box.h"
#include "soms/base/pose.h"
#include "soms/generate/city.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {

/// A polyline that a mover follows at constant speed, heading along it, and starts again at its
/// end. A closed route goes round; an open one is driven to and fro.
struct Route {
  std::vector<Vec3> points;
  bool closed = false;
  double start = 0;  ///< meters along the route at time 0
  double speed = 0;  ///< meters a second
  /// Distance between the two points of the mover that stay on the route, as axles do: the heading
  /// turns smoothly at corners and slopes. 0: the heading of the present line.
  double base = 0;
  /// Meters along the route to each point, and to the first again if closed. Found again by each
  /// call of `at` while empty; `measure` fills it.
  std::vector<double> marks = {};

  [[nodiscard]] bool operator==(const Route&) const = default;

  /// Fills `marks`; to be called again when points change.
  void measure();

  /// Meters from the first point to the last, and on to the first if closed.
  [[nodiscard]] double length() const;

  /// Pose at a time in seconds: +x of the mover along the route, z up. A route of one point, or of
  /// none, stands still (at the origin).
  [[nodiscard]] Pose at(double seconds) const;

  /// The same pose. It is found sooner where `line`, which may be any number, is what a call for a
  /// time shortly before left there. That is the line of the route that the mover is on.
  [[nodiscard]] Pose at(double seconds, std::size_t& line) const;
};

/// A drive of a mover along the streets of a city, following the ground. `clearance` is the height
/// of the mover's origin above the ground. Deterministic in `seed`.
///
/// A closed loop of at most 5 by 5 blocks with quarter turns at crossings, on the right-hand side;
/// movers slower than 3 m/s walk on the sidewalk. At time 0 it is near a crossing, where no
/// furniture stands. The lane is drawn: most pass all that is parked, some do not.
[[nodiscard]] Route street_route(const City& city, std::uint64_t seed, double speed,
                                 double clearance);

/// A flight of a drone over and between the buildings. It is a loop above the streets that climbs
/// and sinks between `lowest` and `highest` meters above ground and cuts corners, some too closely.
[[nodiscard]] Route flight_route(const City& city, std::uint64_t seed, double speed, double lowest,
                                 double highest);

/// A straight horizontal line to and fro through `scene` at the height of `start`, which is where
/// it is at time 0.
[[nodiscard]] Route straight_route(const Box& scene, const Vec3& start, std::uint64_t seed,
                                   double speed);

}  // namespace soms
