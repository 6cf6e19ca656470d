/// \file
/// The ground of a generated city: level crossings, planar streets, sunken blocks.
#pragma once

#include "soms/generate/city.h"

#include <cstdint>

namespace soms::detail {

inline constexpr double kStreetWidth = 20;

/// Lays out streets and heights: fills all of `city` but its mesh. `options` is set.
void lay_out(City& city);

/// Height of crossing (i, j).
[[nodiscard]] double crossing_height(const City& city, std::size_t i, std::size_t j);

/// Height of the terrain at corner (u, v) of the cells of block (i, j): on the kerb where u or v is
/// 0 or `block_cells`, sunken elsewhere.
[[nodiscard]] double terrain_height(const City& city, std::size_t i, std::size_t j, std::uint32_t u,
                                    std::uint32_t v);

/// Appends the parts `terrain` and `roads`.
void add_terrain(City& city);
void add_roads(City& city);

/// Triangles of both.
[[nodiscard]] std::uint64_t ground_triangles(std::uint64_t blocks, std::uint64_t cells);

/// A generator for thing number `index` of a kind, independent of all others.
[[nodiscard]] Rng rng_for(const City& city, std::uint64_t kind, std::uint64_t index);

}  // namespace soms::detail
