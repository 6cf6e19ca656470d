/// \file
/// A building to be checked for clashes: structure and services, some thousand closed parts each.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms::bench {

/// Two disciplines of one building, in meters, z up. Every number is a float.
struct Building {
  Mesh structure;  ///< slabs, round columns, I-beams, walls with doors
  Mesh services;   ///< pipes and ducts with bends, cable trays, drops
};

/// A building of four wings, turned by different angles, with as many levels as give at least
/// `parts` parts to each discipline. The same parts for the same seed, everywhere.
[[nodiscard]] Building make_building(std::uint64_t parts, std::uint64_t seed);

}  // namespace soms::bench
