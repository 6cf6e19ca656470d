/// \file
/// Triangles on a grid of samples, one at the center of each cell: which samples a triangle covers,
/// and a third coordinate there.
#pragma once

#include "soms/base/vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace soms::command {

/// The sample of column c and row r is at (x + (c + 1/2) cell, y + (r + 1/2) cell).
struct Raster {
  double x = 0;
  double y = 0;
  double cell = 1;
  std::size_t columns = 0;
  std::size_t rows = 0;

  /// The first of `count` samples along an axis that is at or beyond `at`; `count` if none is.
  [[nodiscard]] std::size_t first(double at, double from, std::size_t count) const {
    return static_cast<std::size_t>(
        std::clamp(std::ceil((at - from) / cell - 0.5), 0.0, static_cast<double>(count)));
  }
};

/// Calls `use(column, row, z)` for each sample of a triangle, row by row. A sample on an edge that
/// two triangles share is one's alone, but for rounding. \pre Corners are finite. \returns How many
/// samples and rows there were, as a measure of the work.
template <typename Use>
std::size_t for_each_sample(const Raster& raster, const Vec3& a, const Vec3& b, const Vec3& c,
                            const Use& use) {
  std::size_t work = 0;
  const auto [low, high] = std::minmax({a.y, b.y, c.y});
  const std::size_t end = raster.first(high, raster.y, raster.rows);
  for (std::size_t row = raster.first(low, raster.y, raster.rows); row < end; ++row) {
    const double y = raster.y + (static_cast<double>(row) + 0.5) * raster.cell;
    // Where the row enters and leaves the triangle, and z there.
    std::array<std::pair<double, double>, 3> ends{};
    std::size_t count = 0;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if ((p.y <= y) != (q.y <= y)) {
        const double share = (y - p.y) / (q.y - p.y);
        ends[count++] = {p.x + share * (q.x - p.x), p.z + share * (q.z - p.z)};
      }
    }
    if (count < 2) {
      continue;
    }
    if (ends[1].first < ends[0].first) {
      std::swap(ends[0], ends[1]);
    }
    const auto& [left, z_left] = ends[0];
    const auto& [right, z_right] = ends[1];
    const std::size_t last = raster.first(right, raster.x, raster.columns);
    std::size_t column = raster.first(left, raster.x, raster.columns);
    work += 1 + (last > column ? last - column : 0);
    for (; column < last; ++column) {
      const double x = raster.x + (static_cast<double>(column) + 0.5) * raster.cell;
      const double share = std::clamp((x - left) / (right - left), 0.0, 1.0);
      use(column, row, z_left + share * (z_right - z_left));
    }
  }
  return work;
}

}  // namespace soms::command
