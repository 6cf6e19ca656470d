#include "soms/generate/detail/ground.h"

#include "soms/base/arithmetic.h"
#include "soms/generate/detail/circle.h"
#include "soms/generate/detail/pavement.h"
#include "soms/generate/detail/solids.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

constexpr double kLeastSpacing = 120;
constexpr double kLeastPavedSpacing = 90;
constexpr double kDeepest = 1.2;  ///< how far the middle of a block may lie below its kerbs

/// Rolling hills. The slope along either axis is at most 0.037, so that what is left of a street
/// between two level crossings (at least five sixths of it) is at most 4.1 % steep.
class Hills {
 public:
  explicit Hills(std::uint64_t seed) {
    Rng rng(seed);
    for (double& p : phase_) {
      p = rng.unit();
    }
  }

  [[nodiscard]] double at(double x, double y) const {
    return 6 * on_circle(x / 2000 + phase_[0]).sine * on_circle(y / 2100 + phase_[1]).cosine +
           1.4 * on_circle((x + y) / 1060 + phase_[2]).sine +
           0.5 * on_circle((x - 2 * y) / 820 + phase_[3]).cosine;
  }

 private:
  double phase_[4] = {};
};

/// Most blocks along a side that `triangles` can pay for and `size` has room for.
std::uint64_t blocks_for(const CityOptions& options) {
  const double least = options.streets == CityStreets::paved ? kLeastPavedSpacing : kLeastSpacing;
  const auto room = static_cast<std::uint64_t>((options.size - kStreetWidth) / least);
  std::uint64_t blocks = 1;
  while (blocks < room && ground_triangles(blocks + 1, 1) <= 3 * options.triangles / 20) {
    ++blocks;
  }
  return blocks;
}

std::uint32_t cells_for(std::uint64_t triangles, std::uint64_t blocks) {
  const double each =
      0.04 * static_cast<double>(triangles) / static_cast<double>(2 * blocks * blocks);
  return static_cast<std::uint32_t>(std::clamp(std::sqrt(each), 1.0, 64.0));
}

struct Span {
  double from;
  double to;
};

/// Two triangles over a rectangle, with a height at each end in x (or in y).
void add_slab(Mesh& mesh, const Span& x, const Span& y, const std::array<double, 4>& heights) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.push_back({x.from, y.from, heights[0]});
  mesh.vertices.push_back({x.to, y.from, heights[1]});
  mesh.vertices.push_back({x.to, y.to, heights[2]});
  mesh.vertices.push_back({x.from, y.to, heights[3]});
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// Number of the line whose block, and the street beyond that block, hold a coordinate.
std::size_t line_below(const City& city, double c) {
  const double half = 0.5 * city.street_width;
  const double place = (c - city.street_lines.front() - half) / city.street_spacing;
  const double last = static_cast<double>(city.street_lines.size() - 2);
  return static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, last));
}

/// Where a coordinate lies between two lines: 0 on the street below, 1 on the street above.
double share_between(const City& city, double c, std::size_t line) {
  const double half = 0.5 * city.street_width;
  const double from = city.street_lines[line] + half;
  const double to = city.street_lines[line + 1] - half;
  return std::clamp((c - from) / (to - from), 0.0, 1.0);
}

}  // namespace

Rng rng_for(const City& city, std::uint64_t kind, std::uint64_t index) {
  Rng seed(city.options.seed);
  Rng mixed(seed.next() ^ (kind << 56) ^ index);
  return Rng(mixed.next());
}

std::uint64_t ground_triangles(std::uint64_t blocks, std::uint64_t cells) {
  const std::uint64_t lines = blocks + 1;
  return 2 * (lines * lines + 2 * blocks * lines + blocks * blocks * cells * cells);
}

void lay_out(City& city) {
  const std::uint64_t blocks = blocks_for(city.options);
  city.street_width = kStreetWidth;
  city.street_spacing = (city.options.size - kStreetWidth) / static_cast<double>(blocks);
  city.block_cells = cells_for(city.options.triangles, blocks);
  const double first = 0.5 * (kStreetWidth - city.options.size);
  for (std::uint64_t i = 0; i <= blocks; ++i) {
    city.street_lines.push_back(first + city.street_spacing * static_cast<double>(i));
  }
  const Hills hills(city.options.seed);
  for (const double y : city.street_lines) {
    for (const double x : city.street_lines) {
      city.crossing_heights.push_back(hills.at(x, y));
    }
  }
}

double crossing_height(const City& city, std::size_t i, std::size_t j) {
  return city.crossing_heights[i + j * city.street_lines.size()];
}

double terrain_height(const City& city, std::size_t i, std::size_t j, std::uint32_t u,
                      std::uint32_t v) {
  const auto n = static_cast<double>(city.block_cells);
  const double s = u / n;
  const double t = v / n;
  const double low = crossing_height(city, i, j) * (1 - s) + crossing_height(city, i + 1, j) * s;
  const double high =
      crossing_height(city, i, j + 1) * (1 - s) + crossing_height(city, i + 1, j + 1) * s;
  const std::uint64_t place =
      ((i + j * city.street_lines.size()) << 13) + std::uint64_t{v} * 65 + std::uint64_t{u};
  const double bump = rng_for(city, 1, place).uniform(0.4, 1);
  return low * (1 - t) + high * t - kDeepest * bump * 16 * s * (1 - s) * t * (1 - t);
}

void add_terrain(City& city) {
  const std::size_t blocks = city.street_lines.size() - 1;
  const double half = 0.5 * city.street_width;
  const double cell = (city.street_spacing - city.street_width) / city.block_cells;
  Mesh& mesh = city.mesh;
  const std::uint32_t part = open_part(mesh, "terrain");
  const std::uint32_t side = city.block_cells + 1;
  for (std::size_t j = 0; j < blocks; ++j) {
    for (std::size_t i = 0; i < blocks; ++i) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (std::uint32_t v = 0; v < side; ++v) {
        for (std::uint32_t u = 0; u < side; ++u) {
          const double x = u == side - 1 ? city.street_lines[i + 1] - half
                                         : city.street_lines[i] + half + cell * u;
          const double y = v == side - 1 ? city.street_lines[j + 1] - half
                                         : city.street_lines[j] + half + cell * v;
          mesh.vertices.push_back({x, y, terrain_height(city, i, j, u, v)});
        }
      }
      for (std::uint32_t v = 0; v + 1 < side; ++v) {
        for (std::uint32_t u = 0; u + 1 < side; ++u) {
          const std::uint32_t a = first + v * side + u;
          mesh.triangles.push_back({a, a + 1, a + side + 1});
          mesh.triangles.push_back({a, a + side + 1, a + side});
        }
      }
    }
  }
  close_part(mesh, part);
}

void add_roads(City& city) {
  const std::size_t lines = city.street_lines.size();
  const double half = 0.5 * city.street_width;
  const auto on = [&](std::size_t i) {
    return Span{city.street_lines[i] - half, city.street_lines[i] + half};
  };
  const auto between = [&](std::size_t i) {
    return Span{city.street_lines[i] + half, city.street_lines[i + 1] - half};
  };
  const std::uint32_t part = open_part(city.mesh, "roads");
  for (std::size_t j = 0; j < lines; ++j) {
    for (std::size_t i = 0; i < lines; ++i) {
      const double here = crossing_height(city, i, j);
      add_slab(city.mesh, on(i), on(j), {here, here, here, here});
      if (i + 1 < lines) {
        const double east = crossing_height(city, i + 1, j);
        add_slab(city.mesh, between(i), on(j), {here, east, east, here});
      }
      if (j + 1 < lines) {
        const double north = crossing_height(city, i, j + 1);
        add_slab(city.mesh, on(i), between(j), {here, here, north, north});
      }
    }
  }
  close_part(city.mesh, part);
}

}  // namespace soms::detail

namespace soms {

double City::ground(double x, double y) const {
  const PlainArithmetic plain;
  const double kerb = detail::on_sidewalk(*this, x, y) ? detail::kKerb : 0;
  const std::size_t i = detail::line_below(*this, x);
  const std::size_t j = detail::line_below(*this, y);
  const double s = detail::share_between(*this, x, i);
  const double t = detail::share_between(*this, y, j);
  const double cells = block_cells;
  const double last = cells - 1;
  const double cell_x = std::clamp(std::floor(s * cells), 0.0, last);
  const double cell_y = std::clamp(std::floor(t * cells), 0.0, last);
  const auto u = static_cast<std::uint32_t>(cell_x);
  const auto v = static_cast<std::uint32_t>(cell_y);
  const double fx = s * cells - cell_x;
  const double fy = t * cells - cell_y;
  // On streets s or t is 0 or 1, so the terrain's kerb is the road's height across all its width.
  const double a = detail::terrain_height(*this, i, j, u, v);
  const double c = detail::terrain_height(*this, i, j, u + 1, v + 1);
  if (fx >= fy) {
    const double b = detail::terrain_height(*this, i, j, u + 1, v);
    return settled(a + fx * (b - a) + fy * (c - b) + kerb);
  }
  const double d = detail::terrain_height(*this, i, j, u, v + 1);
  return settled(a + fy * (d - a) + fx * (c - d) + kerb);
}

}  // namespace soms
