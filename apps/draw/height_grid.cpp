#include "apps/draw/height_grid.h"

#include "apps/draw/raster.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace soms::command {

namespace {

/// Cells of the ground estimate along the longer side, at most.
constexpr double kMostTiles = 96;
/// A tile narrower than this sees roofs alone.
constexpr double kLeastTile = 30;
/// Vertices that a tile needs before its ground is believed.
constexpr std::size_t kLeastVertices = 8;
/// Of a tile's vertices this share may lie below the ground: cellars, noise.
constexpr double kBelowGround = 0.05;
/// What a mover drives over rather than into.
constexpr double kStep = 2.5;

/// Kinds of surface of all triangles; a part within a part overrides it.
std::vector<Surface> surfaces_of(const MeshView& mesh) {
  std::vector<Surface> surfaces(mesh.triangles.size(), Surface::building);
  for (const Part& part : mesh.parts) {
    const Surface surface = surface_named(part.name);
    if (surface != Surface::building) {
      const auto first = surfaces.begin() + part.first;
      std::fill(first, first + part.count, surface);
    }
  }
  return surfaces;
}

}  // namespace

Surface surface_named(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto says = [&](std::string_view word) { return lower.find(word) != std::string::npos; };
  if (says("road") || says("street") || says("pavement") || says("plaza")) {
    return Surface::street;
  }
  if (says("water") || says("river") || says("canal")) {
    return Surface::water;
  }
  if (says("terrain") || says("ground") || says("landuse") || says("grass")) {
    return Surface::ground;
  }
  if (says("furniture") || says("vegetation") || says("tree")) {
    return Surface::furniture;
  }
  return Surface::building;
}

HeightGrid::HeightGrid(const Box& area, std::size_t cells) {
  origin_ = area.lower;
  const Vec3 extent = area.extent();
  const double longer = std::max(extent.x, extent.y);
  const auto most = static_cast<double>(cells);
  cell_ = longer > 0 ? longer / most : 1;
  const auto count = [&](double side, double unit) {
    return static_cast<std::size_t>(std::clamp(std::ceil(side / unit), 1.0, most));
  };
  columns_ = count(extent.x, cell_);
  rows_ = count(extent.y, cell_);
  tops_.assign(columns_ * rows_, std::numeric_limits<double>::lowest());
  surfaces_.assign(columns_ * rows_, Surface::nothing);
  tile_ = std::max({kLeastTile, longer / kMostTiles, cell_});
  tile_columns_ = count(extent.x, tile_);
  tile_rows_ = count(extent.y, tile_);
}

void HeightGrid::add(const MeshView& mesh, const Limits& limits) {
  constexpr std::size_t kCellsBetweenAsks = 1U << 20U;
  const std::vector<Surface> surfaces = surfaces_of(mesh);
  std::size_t cells = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle triangle = mesh.triangle(i);
    cells += 16 + add(triangle, surfaces[i]);
    if (cells >= kCellsBetweenAsks) {
      check_stop(limits);
      cells = 0;
    }
    for (const Vec3& corner : {triangle.a, triangle.b, triangle.c}) {
      const auto tile = [&](double at, double from, std::size_t count) {
        return static_cast<std::uint32_t>(
            std::clamp((at - from) / tile_, 0.0, static_cast<double>(count - 1)));
      };
      const std::uint32_t column = tile(corner.x, origin_.x, tile_columns_);
      const std::uint32_t row = tile(corner.y, origin_.y, tile_rows_);
      lowest_.emplace_back(row * static_cast<std::uint32_t>(tile_columns_) + column, corner.z);
    }
  }
}

std::size_t HeightGrid::add(const Triangle& t, Surface surface) {
  return for_each_sample({origin_.x, origin_.y, cell_, columns_, rows_}, t.a, t.b, t.c,
                         [&](std::size_t column, std::size_t row, double z) {
                           const std::size_t k = row * columns_ + column;
                           if (z > tops_[k]) {
                             tops_[k] = z;
                             surfaces_[k] = surface;
                           }
                         });
}

void HeightGrid::find_ground(const Limits& limits) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  ground_.assign(tile_columns_ * tile_rows_, kUnknown);
  std::uint32_t queried = 0;
  std::sort(lowest_.begin(), lowest_.end(), [&queried, &limits](const auto& a, const auto& b) {
    if (++queried % (1U << 20U) == 0) {
      check_stop(limits);
    }
    return a < b;
  });
  const auto quantile = [&](std::size_t begin, std::size_t end) {
    const auto skip = static_cast<std::size_t>(kBelowGround * static_cast<double>(end - begin));
    return lowest_[begin + skip].second;
  };
  for (std::size_t begin = 0; begin < lowest_.size();) {
    std::size_t end = begin;
    while (end < lowest_.size() && lowest_[end].first == lowest_[begin].first) {
      ++end;
    }
    if (end - begin >= kLeastVertices) {
      ground_[lowest_[begin].first] = quantile(begin, end);
    }
    begin = end;
  }
  known_.clear();
  for (const double ground : ground_) {
    known_.push_back(std::isnan(ground) ? 0 : 1);
  }
  if (std::all_of(ground_.begin(), ground_.end(), [](double g) { return std::isnan(g); })) {
    const double least = lowest_.empty() ? origin_.z : lowest_.front().second;
    std::fill(ground_.begin(), ground_.end(), least);
  }
  lowest_ = {};
  fill_unknown_tiles();
}

/// Spreads what is known outwards, ring by ring, as the mean of the known neighbors.
void HeightGrid::fill_unknown_tiles() {
  const auto columns = static_cast<std::ptrdiff_t>(tile_columns_);
  const auto rows = static_cast<std::ptrdiff_t>(tile_rows_);
  for (bool open = true; open;) {
    open = false;
    const std::vector<double> before = ground_;
    for (std::ptrdiff_t row = 0; row < rows; ++row) {
      for (std::ptrdiff_t column = 0; column < columns; ++column) {
        double& here = ground_[static_cast<std::size_t>(row * columns + column)];
        if (!std::isnan(here)) {
          continue;
        }
        double sum = 0;
        int known = 0;
        for (const auto& [dx, dy] :
             {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
          const std::ptrdiff_t x = column + dx;
          const std::ptrdiff_t y = row + dy;
          if (x < 0 || y < 0 || x >= columns || y >= rows) {
            continue;
          }
          const double near = before[static_cast<std::size_t>(y * columns + x)];
          if (!std::isnan(near)) {
            sum += near;
            ++known;
          }
        }
        if (known > 0) {
          here = sum / known;
        }
        open = true;
      }
    }
  }
}

double HeightGrid::tile_ground(std::ptrdiff_t column, std::ptrdiff_t row) const {
  const auto x =
      std::clamp<std::ptrdiff_t>(column, 0, static_cast<std::ptrdiff_t>(tile_columns_) - 1);
  const auto y = std::clamp<std::ptrdiff_t>(row, 0, static_cast<std::ptrdiff_t>(tile_rows_) - 1);
  return ground_[static_cast<std::size_t>(y) * tile_columns_ + static_cast<std::size_t>(x)];
}

double HeightGrid::ground(double x, double y) const {
  // Between the centers of four tiles; outside, as at the rim.
  const auto place = [&](double at, double from, std::size_t count) {
    return std::clamp((at - from) / tile_ - 0.5, -1.0, static_cast<double>(count));
  };
  const double u = place(x, origin_.x, tile_columns_);
  const double v = place(y, origin_.y, tile_rows_);
  const auto column = static_cast<std::ptrdiff_t>(std::floor(u));
  const auto row = static_cast<std::ptrdiff_t>(std::floor(v));
  const double s = u - std::floor(u);
  const double t = v - std::floor(v);
  return (1 - t) * ((1 - s) * tile_ground(column, row) + s * tile_ground(column + 1, row)) +
         t * ((1 - s) * tile_ground(column, row + 1) + s * tile_ground(column + 1, row + 1));
}

bool HeightGrid::built_near(double x, double y) const {
  const double column = (x - origin_.x) / tile_;
  const double row = (y - origin_.y) / tile_;
  if (!(column >= 0 && row >= 0 && column < static_cast<double>(tile_columns_) &&
        row < static_cast<double>(tile_rows_))) {
    return false;
  }
  return known_[static_cast<std::size_t>(row) * tile_columns_ + static_cast<std::size_t>(column)] !=
         0;
}

double HeightGrid::height(std::size_t column, std::size_t row) const {
  if (surface(column, row) == Surface::nothing) {
    return 0;
  }
  const double x = origin_.x + (static_cast<double>(column) + 0.5) * cell_;
  const double y = origin_.y + (static_cast<double>(row) + 0.5) * cell_;
  return top(column, row) - ground(x, y);
}

double HeightGrid::standing(double x, double y, double reach) const {
  double level = ground(x, y);
  const double limit = level + kStep;
  const auto cell_of = [&](double at, double from) {
    return static_cast<std::ptrdiff_t>(std::floor((at - from) / cell_));
  };
  const auto rows = static_cast<std::ptrdiff_t>(rows_);
  const auto columns = static_cast<std::ptrdiff_t>(columns_);
  const std::ptrdiff_t row_end = std::min(rows - 1, cell_of(y + reach, origin_.y));
  const std::ptrdiff_t column_end = std::min(columns - 1, cell_of(x + reach, origin_.x));
  for (auto row = std::max<std::ptrdiff_t>(0, cell_of(y - reach, origin_.y)); row <= row_end;
       ++row) {
    for (auto column = std::max<std::ptrdiff_t>(0, cell_of(x - reach, origin_.x));
         column <= column_end; ++column) {
      const auto k = static_cast<std::size_t>(row * columns + column);
      if (surfaces_[k] == Surface::nothing) {
        continue;
      }
      if (tops_[k] > limit) {
        return std::numeric_limits<double>::quiet_NaN();
      }
      level = std::max(level, tops_[k]);
    }
  }
  return level;
}

}  // namespace soms::command
