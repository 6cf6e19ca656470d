/// \file
/// Buildings of a generated city.
#pragma once

#include "soms/generate/city.h"
#include "soms/generate/detail/solids.h"

#include <cstdint>
#include <vector>

namespace soms::detail {

/// Kinds of buildings.
enum class BuildingKind { block, gabled, tower, corner, courtyard, bastion };

/// A building before its triangles are made.
struct Building {
  BuildingKind kind = BuildingKind::block;
  std::uint64_t index = 0;    ///< number of its lot: what its details are drawn from
  Frame frame;                ///< on the ground at its lowest corner
  Outline outline;            ///< of its walls
  double wall = 0;            ///< height of the walls
  std::uint64_t details = 0;  ///< balconies, window frames, roof units, 12 triangles each
};

/// Lots of a city, each with room for one building.
[[nodiscard]] std::uint64_t lot_count(const City& city);

/// Triangles of a building without its details.
[[nodiscard]] std::uint64_t shell_triangles(const Building& building);

/// Places buildings on the lots along the streets, then behind them, until `budget` triangles are
/// spent to the last one but at most 11; details fill what the shells leave.
[[nodiscard]] std::vector<Building> plan_buildings(const City& city, std::uint64_t budget);

/// Appends the part `buildings`, one part a building, and single triangles (pennants on the roof of
/// the last one) until the part has `budget` triangles.
void add_buildings(City& city, const std::vector<Building>& buildings, std::uint64_t budget,
                   const Limits& limits);

}  // namespace soms::detail
