/// \file
/// The city's part of the map: outlines of what stands how high.
#pragma once

#include "soms/base/box.h"

#include "apps/world/map_layers.h"
#include "apps/world/world.h"

#include <cstddef>
#include <string>
#include <vector>

namespace soms::command {

/// The city as layers, the lowest first.
struct MapCity {
  Box area;  ///< what the map shows
  double cell = 1;
  std::vector<MapLayer> layers;
};

/// Outlines of the city within `area`. All paths together stay below `budget` bytes: lines are made
/// straighter, and small shapes dropped, until they do.
[[nodiscard]] MapCity outline_city(const World& world, const Box& area, std::size_t budget);

}  // namespace soms::command
