#include "apps/soms/simulate/map_city.h"

#include "apps/draw/height_grid.h"
#include "apps/world/map_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace soms::command {

namespace {

constexpr std::size_t kCells = 1600;
constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr std::array kShades{"#dcd5c8", "#bfb6a6", "#9c9282", "#766d60", "#4f483f"};

MapRegion make_region(const HeightGrid& grid, const std::string& color, const std::string& legend,
                      const std::function<bool(std::size_t, std::size_t)>& holds) {
  std::vector<std::uint8_t> inside(grid.columns() * grid.rows(), 0);
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    for (std::size_t column = 0; column < grid.columns(); ++column) {
      inside[row * grid.columns() + column] = holds(column, row) ? 1 : 0;
    }
  }
  return map_region(color, legend, inside, grid.columns(), grid.rows());
}

/// Round heights that divide the buildings into about equal areas, but for the tallest few.
std::vector<double> steps_of(const HeightGrid& grid) {
  std::vector<double> heights;
  for (std::size_t row = 0; row < grid.rows(); ++row) {
    for (std::size_t column = 0; column < grid.columns(); ++column) {
      if (grid.surface(column, row) == Surface::building &&
          grid.height(column, row) >= kLeastBuilding) {
        heights.push_back(grid.height(column, row));
      }
    }
  }
  std::vector<double> steps{kLeastBuilding};
  if (heights.empty()) {
    return steps;
  }
  std::sort(heights.begin(), heights.end());
  for (const double share : {0.35, 0.65, 0.88, 0.975}) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(heights.size() - 1));
    const double step = round_length(heights[at]);
    if (step > steps.back()) {
      steps.push_back(step);
    }
  }
  return steps;
}

std::string legend_of(const std::vector<double>& steps, std::size_t k) {
  return k + 1 == steps.size() ? fmt::format("above {:g} m", steps[k])
                               : fmt::format("{:g} to {:g} m", steps[k], steps[k + 1]);
}

std::vector<MapRegion> regions_of(const HeightGrid& grid) {
  std::vector<MapRegion> regions;
  const auto all_of = [&](Surface surface) {
    return [&grid, surface](std::size_t column, std::size_t row) {
      return grid.surface(column, row) == surface;
    };
  };
  regions.push_back(make_region(grid, "#c9deea", "water", all_of(Surface::water)));
  regions.push_back(make_region(grid, "#ffffff", "streets", all_of(Surface::street)));
  const std::vector<double> steps = steps_of(grid);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double from = steps[k];
    // NOLINTNEXTLINE(bugprone-narrowing-conversions): infinity is a double
    const double to = k + 1 == steps.size() ? kEndless : steps[k + 1];
    regions.push_back(make_region(
        grid, kShades[k], legend_of(steps, k), [&](std::size_t column, std::size_t row) {
          const double height = grid.height(column, row);
          return grid.surface(column, row) == Surface::building && height >= from && height < to;
        }));
  }
  std::erase_if(regions, [](const MapRegion& region) { return region.loops.empty(); });
  return regions;
}

}  // namespace

MapCity outline_city(const World& world, const Box& area, std::size_t budget) {
  HeightGrid grid(area, kCells);
  for (const Body& body : world.city) {
    grid.add(body.shape.mesh());
  }
  grid.find_ground();
  return {area, grid.cell(), map_layers(regions_of(grid), budget)};
}

}  // namespace soms::command
