/// \file
/// Triangles of unlike sizes: a scene in which nothing but the spread of sizes changes.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms {

/// Options of a scene of unlike triangles.
struct SpreadOptions {
  std::uint64_t triangles = 20'000;  ///< 1 to 100 million
  double ratio = 1;                  ///< longest edge of all over shortest, 1 to 10^6
  double size = 100;                 ///< side of the square that holds all centers
  double height = 5;                 ///< of the slab over that square, 0 to 10^6
  double cover = 20;                 ///< total area over that of the square
  std::uint64_t seed = 1;

  [[nodiscard]] bool operator==(const SpreadOptions&) const = default;
};

/// Equilateral triangles at random places of a flat slab, as in a city, turned at random.
///
/// The logarithms of their edges are spread evenly from the shortest to the longest: triangle of
/// rank r has `shortest * ratio^(r / (triangles - 1))`, ranks being dealt at random. Options that
/// differ in `ratio` alone give the same places, directions and ranks, and the same total area
/// `cover * size * size`: only the spread of sizes changes. The same bits on every machine.
///
/// \errors  ErrorKind::usage for an option out of range; names it.
/// \cost    Linear.
[[nodiscard]] Mesh generate_spread(const SpreadOptions& options = {});

}  // namespace soms
