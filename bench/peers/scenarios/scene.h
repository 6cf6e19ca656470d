/// \file
/// What contestants are asked about: two meshes and sets of poses. All seeded.
#pragma once

#include "soms/base/random.h"

#include "bench/peers/contestants/contestant.h"

#include <cstdint>
#include <string>
#include <vector>

namespace soms::bench {

struct PoseSet {
  std::string name;
  std::vector<Pose> poses;
};

/// One mover, one body that stands still, and where the mover is in each query.
struct Scene {
  std::string name;
  FloatMesh mover;
  FloatMesh fixed;
  std::vector<PoseSet> sets;
};

inline constexpr std::size_t kPoses = 1000;

/// A (2,3) torus knot against its twin: `random`, any rotation, centers 1.0 to 1.9 apart, where
/// about half touch; `near`, slid in along a random line until 0.001 more would touch.
[[nodiscard]] Scene knot_scene(std::uint64_t triangles);

/// The referee's city, 4 km of hills, streets 16 m wide every 100 m, boxes; a car of 1,000
/// triangles 0.1 m above the highest ground under it: `car` anywhere on the streets, 15 % beside a
/// wall from 0.1 m inside to 0.3 m off; `car-path` one drive of 0.2 m a pose with turns.
[[nodiscard]] Scene city_car_scene(std::uint64_t triangles);

/// The same city and a drone of 308 triangles, 2 to 40 m up, any rotation, 15 % beside a wall; and
/// one flight, `drone-path`.
[[nodiscard]] Scene city_drone_scene(std::uint64_t triangles);

/// The city of `soms generate` and its car on its street routes: 50 cars, 20 poses each, half a
/// second apart. Its road slabs are large and slope under the car.
[[nodiscard]] Scene street_scene(std::uint64_t triangles);

/// Meshes from files: 1,000 random places, each on the lowest surface there and 0.1 m above it.
[[nodiscard]] Scene file_scene(const std::string& city, const std::string& mover);

}  // namespace soms::bench
