#include "soms/tree/layout/min_max_grid.h"

#include "soms/base/box.h"
#include "soms/base/portable.h"
#include "soms/tree/layout/detail/grid_cells.h"
#include "soms/tree/layout/wide_tree.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace soms::layout {

namespace {

constexpr double kFlat = 4;              // sides of the ground plan over the third one, at least
constexpr double kCellsABlock = 1.5;     // about four triangles a cell
constexpr double kMostCells = 1U << 20;  // of a row or a column
constexpr std::size_t kChunk = 4096;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Widens a bound that other threads widen too; the outcome has no order.
template <bool kShared, class Closer>
void widen(float& bound, float to, Closer closer) {
  if constexpr (kShared) {
    const AtomicRef<float> shared(bound);
    float now = shared.load(std::memory_order_relaxed);
    while (closer(to, now) && !shared.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
    }
  } else {
    bound = closer(to, bound) ? to : bound;
  }
}

/// Grid in which an interval of so many cells more than one lies in two cells at most.
std::uint32_t grid_for(std::uint32_t span) {
  return span <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(span - 1));
}

}  // namespace

MinMaxGrid::MinMaxGrid(std::span<const TriangleBlock> blocks, const Box& bounds, double scale,
                       const Parallel& parallel) {
  const Vec3 extent = bounds.extent();
  std::array<std::uint8_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return extent[a] > extent[b]; });
  axis_ = order;
  if (blocks.empty() || !(extent[order[1]] > 0) || extent[order[2]] * kFlat > extent[order[1]]) {
    return;
  }
  lay_grids(bounds, scale, blocks.size());
  const Parallel silent{parallel.threads, parallel.stop, {}};
  for_each_chunk(blocks.size(), kChunk, silent, [&](std::size_t begin, std::size_t end) {
    const auto chunk = blocks.subspan(begin, end - begin);
    if (parallel.threads == 1) {
      put<false>(chunk, scale);
    } else {
      put<true>(chunk, scale);
    }
  });
  hand_down();
  hand_up();
}

void MinMaxGrid::lay_grids(const Box& bounds, double scale, std::size_t blocks) {
  const Vec3 extent = bounds.extent();
  const std::array<double, 2> sides = {extent[axis_[0]] * scale, extent[axis_[1]] * scale};
  const double cells = kCellsABlock * static_cast<double>(blocks);
  // By the longer side and the number of its cells, so that no product of sides is needed.
  const double row =
      std::clamp(std::sqrt(cells * (sides[0] / sides[1])), 1.0, std::min(cells, kMostCells));
  cells_a_unit_ = row / sides[0];
  Grid grid;
  for (std::size_t k = 0; k < 2; ++k) {
    corner_[k] = -0.5 * sides[k];
    last_[k] = std::floor(std::min(sides[k] * cells_a_unit_, kMostCells));
  }
  grid.width = static_cast<std::uint32_t>(last_[0]) + 1;
  grid.height = static_cast<std::uint32_t>(last_[1]) + 1;
  std::size_t first = 0;
  for (std::uint32_t k = 0;; ++k) {
    Grid& here = grids_[grid_count_++];
    here = {first, ((grid.width - 1) >> k) + 1, ((grid.height - 1) >> k) + 1};
    first += std::size_t{here.width} * here.height;
    if (here.width == 1 && here.height == 1) {
      break;
    }
  }
  ranges_.resize(first);
  std::fill(ranges_.begin(), ranges_.end(), Range{kInfinity, -kInfinity});
}

template <bool kShared>
void MinMaxGrid::put(std::span<const TriangleBlock> blocks, double scale) {
  const GridFrame frame{{axis_[0], axis_[1], axis_[2]}, corner_, last_, cells_a_unit_, scale};
  GridCells cells;
  for (const TriangleBlock& block : blocks) {
    find_cells(block, frame, cells);
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      const std::array<std::uint32_t, 2> from = {cells.from[0][lane], cells.from[1][lane]};
      const std::array<std::uint32_t, 2> to = {cells.to[0][lane], cells.to[1][lane]};
      const std::uint32_t k = grid_for(std::max(to[0] - from[0], to[1] - from[1]));
      const Grid& grid = grids_[k];
      for (std::size_t y = from[1] >> k; y <= to[1] >> k; ++y) {
        for (std::size_t x = from[0] >> k; x <= to[0] >> k; ++x) {
          Range& range = ranges_[grid.first + y * grid.width + x];
          widen<kShared>(range.lower, cells.least[lane], [](float a, float b) { return a < b; });
          widen<kShared>(range.upper, cells.most[lane], [](float a, float b) { return a > b; });
        }
      }
    }
  }
}

void MinMaxGrid::hand_down() {
  for (std::size_t k = grid_count_ - 1; k-- > 0;) {
    const Grid& fine = grids_[k];
    const Grid& coarse = grids_[k + 1];
    for (std::size_t y = 0; y < fine.height; ++y) {
      const Range* above = &ranges_[coarse.first + (y >> 1) * coarse.width];
      Range* row = &ranges_[fine.first + y * fine.width];
      for (std::size_t x = 0; x < fine.width; ++x) {
        row[x].lower = std::min(row[x].lower, above[x >> 1].lower);
        row[x].upper = std::max(row[x].upper, above[x >> 1].upper);
      }
    }
  }
}

void MinMaxGrid::hand_up() {
  for (std::size_t k = 0; k + 1 < grid_count_; ++k) {
    const Grid& fine = grids_[k];
    const Grid& coarse = grids_[k + 1];
    for (std::size_t y = 0; y < fine.height; ++y) {
      const Range* row = &ranges_[fine.first + y * fine.width];
      Range* above = &ranges_[coarse.first + (y >> 1) * coarse.width];
      for (std::size_t x = 0; x < fine.width; ++x) {
        above[x >> 1].lower = std::min(above[x >> 1].lower, row[x].lower);
        above[x >> 1].upper = std::max(above[x >> 1].upper, row[x].upper);
      }
    }
  }
}

bool MinMaxGrid::clear(const std::array<double, 3>& center,
                       const std::array<double, 3>& half) const {
  std::array<std::uint32_t, 2> from;
  std::array<std::uint32_t, 2> to;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t axis = axis_[k];
    from[k] = cell(k, center[axis] - half[axis]);
    to[k] = cell(k, center[axis] + half[axis]);
  }
  const std::uint32_t k = grid_for(std::max(to[0] - from[0], to[1] - from[1]));
  const Grid& grid = grids_[k];
  const double lower = center[axis_[2]] - half[axis_[2]];
  const double upper = center[axis_[2]] + half[axis_[2]];
  bool meets = false;
  for (std::size_t y = from[1] >> k; y <= to[1] >> k; ++y) {
    for (std::size_t x = from[0] >> k; x <= to[0] >> k; ++x) {
      const Range& range = ranges_[grid.first + y * grid.width + x];
      meets |=
          static_cast<double>(range.lower) <= upper && static_cast<double>(range.upper) >= lower;
    }
  }
  return !meets;
}

}  // namespace soms::layout
