/// \file
/// A city: hills, streets with large road slabs, buildings and street furniture of irregular
/// triangles.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/random.h"
#include "soms/base/words.h"
#include "soms/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace soms {

/// What the streets of a generated city have.
enum class CityStreets {
  bare,   ///< flat slabs and vehicles of few triangles: cities of earlier releases, to the bit
  paved,  ///< sidewalks with kerbs, marks on the lanes, and vehicles with more shape
};

template <>
inline constexpr auto kWords<CityStreets> = words("CityStreets",
                                                  "What the streets of a generated city have.",
                                                  "bare", "paved");

/// Options of a generated city.
struct CityOptions {
  std::uint64_t triangles = 1'000'000;  ///< exactly this many; 1,000 to 100 million
  double size = 4000;                   ///< side of the square, 200 to 100,000 meters
  std::uint64_t seed = 1;
  CityStreets streets = CityStreets::bare;

  [[nodiscard]] bool operator==(const CityOptions&) const = default;
};

/// Side of the square, in whole meters, in which a city of so many triangles is built up. Each
/// triangle has 3 square meters of ground: 245 m for 20,000. The least side is 200 m.
[[nodiscard]] double city_size(std::uint64_t triangles);

/// A generated city: its mesh with parts (terrain, roads, buildings, furniture), and what movers
/// need to stand in it. `ground` and routes need no mesh: it may be moved out.
///
/// Streets run along the `street_lines` in both directions, level at each crossing and planar, at
/// most 5 % steep, between crossings. A street has two lanes (within 5 m of its center line),
/// parked vehicles (5 to 7.2 m) and sidewalks with lamps, trees, benches, signs and bins. Blocks
/// between streets are never higher than their kerbs. Sidewalks of paved streets stand 0.12 m above
/// them; buildings stand back from the street, but
/// their balconies and ledges may reach 0.8 m over the sidewalk.
struct City {
  Mesh mesh;
  double street_spacing = 0;  ///< distance between the center lines of parallel streets
  double street_width = 0;
  std::vector<double> street_lines;  ///< the same x and y coordinates for both directions
  CityOptions options;
  std::vector<double> crossing_heights;  ///< of crossing (i, j) at i + j * street_lines.size()
  std::uint32_t block_cells = 0;         ///< cells of terrain along a side of a block

  [[nodiscard]] bool operator==(const City&) const = default;

  /// Height of the ground or road at a point of the square: the top of what a mover stands on.
  /// Points beyond the square get the height of its nearest edge.
  [[nodiscard]] double ground(double x, double y) const;
};

/// A city of exactly `options.triangles` triangles, the same bits on every machine.
///
/// Parts: `terrain`, `roads`, `buildings` and `furniture` cover all triangles; each building and
/// each piece of furniture is a part below them with its kind in its name. No triangle is without
/// area; areas spread over seven decades. A million triangles (seed 1) have these areas: 5 % are of
/// 0.001 to 0.01 square meters, 36 % to 0.1, 25 % to 1, 8 % to 10, 12 % to 100, 14 % to 1,000. 0.4
/// % (all of them road slabs) are above. Among 5,672 triangles 9 % are above 1,000 and 3 % above
/// 10,000.
///
/// Paved streets add the parts `sidewalks`, closed, and `lane marks`, sheets 0.01 m above the road.
/// A city with too few triangles for them has none. Wheels on the road meet marks, too: what moves
/// should keep more than 0.01 m above a street, and more than 0.12 m where it may leave the lanes.
///
/// `limits` gives the stop; one thread works.
/// \errors  ErrorKind::usage for a count or size out of range, which names the least; cancelled.
/// \cost    Linear: 0.05 s and 40 MB a million triangles.
[[nodiscard]] City generate_city(const CityOptions& options = {}, const Limits& limits = {});

}  // namespace soms
