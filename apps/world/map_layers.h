/// \file
/// Sets of grid cells as filled shapes of a map, few bytes each.
#pragma once

#include "apps/draw/outline.h"
#include "apps/world/map_page.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace soms::command {

/// A set of cells, its color, and its text in the legend.
struct MapRegion {
  std::string color;
  std::string legend;  ///< empty: not explained
  std::vector<Loop> loops;
};

/// The cells whose flag is set, row by row from the south, with a color and a legend. \pre There
/// are `columns * rows` flags.
[[nodiscard]] MapRegion map_region(std::string color, std::string legend,
                                   const std::vector<std::uint8_t>& inside, std::size_t columns,
                                   std::size_t rows);

/// A filled shape of the map, and its text in the legend.
struct MapLayer {
  std::string color;
  std::string legend;  ///< empty: not explained
  std::string path;    ///< in cells, from the south-west corner, y upwards
};

/// Outlines of regions, in their order. All paths together stay below `budget` bytes: lines are
/// made straighter, and small shapes dropped, until they do.
[[nodiscard]] std::vector<MapLayer> map_layers(const std::vector<MapRegion>& regions,
                                               std::size_t budget);

/// Fills the layers, each over those before it. `cell` is the side of a cell of the page's area.
void draw_layers(std::ostream& out, const MapPage& page, const std::vector<MapLayer>& layers,
                 double cell);

}  // namespace soms::command
