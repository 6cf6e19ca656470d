/// \file
/// A city: hills, streets with large road slabs, buildings and street furniture of irregular
/// triangles.
#pragma once

#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms {

/// Options of a generated city.
struct CityOptions {
  std::uint64_t triangles = 1'000'000;  ///< exactly this many; at least 1,000
  double size = 4000;                   ///< side of the square, metres, centred on the origin
  std::uint64_t seed = 1;
};

/// A generated city: its mesh with parts (terrain, roads, buildings, furniture), and what movers
/// need to stand in it.
struct City {
  Mesh mesh;
  double street_spacing = 0;  ///< distance between the center lines of parallel streets
  double street_width = 0;
  std::vector<double> street_lines;  ///< the same x and y coordinates for both directions
  CityOptions options;

  /// Height of the ground or road at a point of the square: the top of what a mover stands on.
  [[nodiscard]] double ground(double x, double y) const;
};

/// \errors  ErrorKind::usage for a count or size out of range; names the least.
[[nodiscard]] City generate_city(const CityOptions& options = {});

}  // namespace soms
