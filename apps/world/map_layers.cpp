#include "apps/world/map_layers.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace soms::command {

namespace {

/// Layers whose lines are true within `tolerance` cells.
std::vector<MapLayer> layers_of(const std::vector<MapRegion>& regions, double tolerance) {
  std::vector<MapLayer> layers;
  for (const MapRegion& region : regions) {
    PathWriter writer;
    for (const Loop& loop : region.loops) {
      const Loop simple = simplified_loop(loop, tolerance);
      if (simple.size() >= 3 &&
          std::abs(static_cast<double>(double_area(simple))) >= 2 * tolerance * tolerance) {
        writer.add(simple, true);
      }
    }
    layers.push_back({region.color, region.legend, writer.path()});
  }
  return layers;
}

std::size_t bytes_of(const std::vector<MapLayer>& layers) {
  std::size_t bytes = 0;
  for (const MapLayer& layer : layers) {
    bytes += layer.path.size();
  }
  return bytes;
}

}  // namespace

MapRegion map_region(std::string color, std::string legend, const std::vector<std::uint8_t>& inside,
                     std::size_t columns, std::size_t rows) {
  return {std::move(color), std::move(legend), outline(inside, columns, rows)};
}

std::vector<MapLayer> map_layers(const std::vector<MapRegion>& regions, std::size_t budget) {
  double tolerance = 0.75;
  std::vector<MapLayer> layers = layers_of(regions, tolerance);
  while (bytes_of(layers) > budget) {
    tolerance *= 1.15;
    layers = layers_of(regions, tolerance);
  }
  return layers;
}

void draw_layers(std::ostream& out, const MapPage& page, const std::vector<MapLayer>& layers,
                 double cell) {
  const double unit = cell * page.scale;
  out << fmt::format(
      "<g transform=\"translate({:.2f} {:.2f}) scale({:.5f} -{:.5f})\" "
      "fill-rule=\"evenodd\" stroke-width=\".6\">\n",
      page.left, page.top + page.height, unit, unit);
  for (const MapLayer& layer : layers) {
    out << fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}\"/>\n", layer.color, layer.path);
  }
  out << "</g>\n";
}

}  // namespace soms::command
