#include "apps/view/verbs/sight_map.h"

#include "apps/cli/length_unit.h"
#include "apps/cli/text.h"
#include "apps/draw/height_grid.h"
#include "apps/draw/look.h"
#include "apps/view/verbs/ray_picture.h"
#include "apps/view/verbs/render_camera.h"
#include "apps/world/map_layers.h"
#include "apps/world/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

namespace soms::view {

namespace {

constexpr std::size_t kMapCells = 800;
constexpr std::size_t kMapBudget = 400'000;
constexpr std::size_t kMostOfTitle = 24;

/// What the cells of a map show, row by row from the south.
struct CellFlags {
  std::vector<std::uint8_t> ground, roof, ground_seen, roof_seen;

  explicit CellFlags(std::size_t cells)
      : ground(cells, 0), roof(cells, 0), ground_seen(cells, 0), roof_seen(cells, 0) {}
};

/// The cells of a map.
struct LookedDown {
  command::MapPage page;
  command::HeightGrid grid;
  CellFlags flags;
};

/// The rays from above to the centers of a row of cells.
std::vector<Ray> rays_down(const command::HeightGrid& grid, std::size_t row, double top) {
  std::vector<Ray> rays;
  rays.reserve(grid.columns());
  for (std::size_t column = 0; column < grid.columns(); ++column) {
    const double x = grid.origin().x + (static_cast<double>(column) + 0.5) * grid.cell();
    const double y = grid.origin().y + (static_cast<double>(row) + 0.5) * grid.cell();
    rays.push_back({{x, y, top}, {0, 0, -1}});
  }
  return rays;
}

CellFlags look_down(const ViewScene& scene, const Vec3& observer, const command::HeightGrid& grid,
                    double top, SightMap& map, const Limits& limits) {
  CellFlags flags(grid.columns() * grid.rows());
  const Limits inner = limits.silent();
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    check_stop(limits);
    const std::vector<Ray> rays = rays_down(grid, row, top);
    const std::vector<SurfaceHit> hits = scene.first_hits(rays, true, inner);
    const std::vector<std::uint8_t> seen = seen_from(scene, observer, hits, rays, inner);
    for (std::size_t column = 0; column < hits.size(); ++column) {
      if (!hits[column].body) {
        continue;
      }
      const Vec3& at = hits[column].point;
      const bool high = at.z - grid.ground(at.x, at.y) >= command::kLeastBuilding;
      const std::size_t cell = row * grid.columns() + column;
      (high ? flags.roof : flags.ground)[cell] = 1;
      (high ? flags.roof_seen : flags.ground_seen)[cell] = seen[column];
      ++map.surface;
      map.in_sight += seen[column];
    }
    if (limits.progress) {
      limits.progress(static_cast<double>(row + 1) / static_cast<double>(grid.rows()));
    }
  }
  return flags;
}

std::vector<command::MapLayer> layers_of(const CellFlags& flags, const command::HeightGrid& grid) {
  const auto region = [&](const char* color, const char* legend,
                          const std::vector<std::uint8_t>& cells) {
    return command::map_region(color, legend, cells, grid.columns(), grid.rows());
  };
  std::vector<command::MapRegion> regions{region("#ffe2a0", "ground in sight", flags.ground_seen),
                                          region("#e69f00", "roofs in sight", flags.roof_seen),
                                          region("#d9dade", "ground, hidden", flags.ground),
                                          region("#969ca5", "roofs, hidden", flags.roof)};
  // What is seen lies above what is there, so hidden cells are drawn first and listed last.
  std::rotate(regions.begin(), regions.begin() + 2, regions.end());
  std::erase_if(regions, [](const command::MapRegion& r) { return r.loops.empty(); });
  return command::map_layers(regions, kMapBudget);
}

void draw_observer(std::ostream& out, const command::MapPage& page, const Vec3& observer) {
  out << fmt::format(
      "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"7\" fill=\"#fff\"/>\n"
      "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"5\" fill=\"{2}\"/>\n",
      page.x(observer.x), page.y(observer.y), look::hex(look::kBodyA.light));
}

}  // namespace

namespace {

LookedDown look_at_cells(const ViewScene& scene, const Vec3& observer, SightMap& map,
                         const Limits& limits) {
  Box bounds = scene_bounds(scene);
  bounds.grow(observer);
  const double top = bounds.upper.z + std::max(1.0, bounds.extent().z);
  command::MapPage page = command::make_map_page(bounds, scene.unit());
  command::HeightGrid grid(page.area, kMapCells);
  for (std::uint32_t k = 0; k < scene.city_parts(); ++k) {
    grid.add(scene.body(city_part(k)).shape.mesh(), limits);
  }
  grid.find_ground(limits);
  map.cell = grid.cell();
  CellFlags flags = look_down(scene, observer, grid, top, map, limits);
  return {std::move(page), std::move(grid), std::move(flags)};
}

}  // namespace

SightMap sight_grid(const ViewScene& scene, const Vec3& observer, const Limits& limits) {
  SightMap made;
  const LookedDown looked = look_at_cells(scene, observer, made, limits);
  const command::HeightGrid& grid = looked.grid;
  const CellFlags& flags = looked.flags;
  made.text = fmt::format(
      "ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {}\nNODATA_value -9999\n",
      grid.columns(), grid.rows(), grid.origin().x, grid.origin().y, grid.cell());
  for (std::size_t row = grid.rows(); row-- > 0;) {  // the north comes first
    for (std::size_t column = 0; column < grid.columns(); ++column) {
      const std::size_t k = row * grid.columns() + column;
      made.text += column == 0 ? "" : " ";
      made.text += flags.ground_seen[k] != 0 || flags.roof_seen[k] != 0 ? "1"
                   : flags.ground[k] != 0 || flags.roof[k] != 0         ? "0"
                                                                        : "-9999";
    }
    made.text += '\n';
  }
  return made;
}

SightMap draw_sight_map(const ViewScene& scene, const Vec3& observer, const Limits& limits) {
  SightMap map;
  const LookedDown looked = look_at_cells(scene, observer, map, limits);
  const auto& [page, grid, flags] = looked;
  const std::vector<command::MapLayer> layers = layers_of(flags, grid);
  std::ostringstream out;
  command::open_map(
      out, page, scene.title(),
      fmt::format("Map from above, north up, of what ({:g}, {:g}, {:g}) sees: {}.", observer.x,
                  observer.y, observer.z,
                  map.surface == 0 ? "nothing is there" : in_percent(map.in_sight, map.surface)));
  command::draw_layers(out, page, layers, grid.cell());
  command::draw_grid(out, page);
  draw_observer(out, page, observer);
  command::close_map(out, page);
  command::MapPanel panel(out, page);
  panel.title(scene.title().size() <= kMostOfTitle ? scene.title()
                                                   : scene.title().substr(0, kMostOfTitle) + "...");
  panel.line("what a point sees of it, from above; north is up");
  panel.head("The point");
  panel.keyed("<circle r=\"5\" fill=\"" + look::hex(look::kBodyA.light) + "\"/>",
              fmt::format("({:g}, {:g}, {:g})", observer.x, observer.y, observer.z));
  panel.head(map.surface == 0 ? "Nothing is there"
                              : in_percent(map.in_sight, map.surface) + " is in sight");
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
    panel.keyed_color(layer->color, layer->legend);
  }
  panel.line(fmt::format("cells of {:.3g} {}, {} of them with a surface", map.cell,
                         command::unit_name(scene.unit()), command::with_commas(map.surface)));
  panel.line("outlines are simplified");
  out << "</svg>\n";
  map.text = std::move(out).str();
  return map;
}

}  // namespace soms::view
