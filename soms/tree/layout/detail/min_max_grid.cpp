#include "soms/tree/layout/detail/min_max_grid.h"

#include "soms/base/box.h"
#include "soms/base/parallel.h"
#include "soms/base/portable.h"
#include "soms/tree/layout/detail/block_bands.h"
#include "soms/tree/layout/detail/height_mask.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace soms::layout {

namespace {

constexpr double kFlat = 4;              // sides of the ground plan over the third one, at least
constexpr double kCellsABlock = 1;       // about six triangles a cell
constexpr double kMostCells = 1U << 20;  // of a row or a column
constexpr std::uint64_t kCellsATriangle = 64;  // at most
constexpr std::uint64_t kCellsOfSmall = 4;     // of a block
constexpr std::uint32_t kColumnBits = 2;       // a cell has four columns along each axis
constexpr std::uint32_t kColumn = (1U << kColumnBits) - 1;
constexpr std::size_t kChunk = 4096;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Changes a number that other threads may change too, to one that has no order.
template <bool kShared, class T, class Change>
void change(T& number, const Change& changed) {
  if constexpr (kShared) {
    const AtomicRef<T> shared(number);
    T now = shared.load(std::memory_order_relaxed);
    while (changed(now) != now &&
           !shared.compare_exchange_weak(now, changed(now), std::memory_order_relaxed)) {
    }
  } else {
    number = changed(number);
  }
}

/// Columns of a cell that a band has, which begins and ends in the given ones.
QuarterRange columns_of(std::uint32_t cell, std::uint32_t from, std::uint32_t to) {
  return {cell == from >> kColumnBits ? from & kColumn : 0,
          cell == to >> kColumnBits ? to & kColumn : kColumn};
}

/// What of a box is taken up by a cell, in the given ones of whose columns it is.
template <class Cell>
std::uint64_t taken_by(const Cell& cell, std::uint64_t columns, const PlanBox& box) {
  const auto ends = slice_ends(cell.lower, cell.upper);
  const std::uint64_t covered =
      columns * kSlices.of({slice_of(box.lower, ends), slice_of(box.upper, ends)});
  const std::uint64_t in_range =
      (ends[0] <= box.upper ? 1U : 0U) & (ends[4] >= box.lower ? 1U : 0U);
  return covered & cell.taken & (0 - in_range);
}

/// Slices of `to` that the slices of `from` reach into, one of `from` after the other.
class SliceMap {
 public:
  template <class Cell>
  SliceMap(const Cell& own, const Cell& other)
      : SliceMap(slice_ends(own.lower, own.upper), slice_ends(other.lower, other.upper)) {}

  SliceMap(const std::array<double, 5>& from, const std::array<double, 5>& to) {
    for (std::size_t a = 0; a < 4; ++a) {
      const QuarterRange range{slice_of(from[a], to), slice_of(from[a + 1], to)};
      slices_[a] = kSlices.of(range);
    }
  }

  /// \p columns, bits of 16, in all slices that `slice` reaches into.
  [[nodiscard]] std::uint64_t put(std::uint64_t columns, std::size_t slice) const {
    return columns * slices_[slice];
  }

 private:
  std::array<std::uint64_t, 4> slices_;
};

/// Sixteen columns of one slice.
std::uint64_t columns_in(std::uint64_t taken, std::size_t slice) {
  return taken >> (16 * slice) & 0xFFFF;
}

/// Columns of a quarter, each made into two by two.
std::uint64_t widened(std::uint64_t columns, std::uint32_t quarter_x, std::uint32_t quarter_y) {
  const std::uint64_t own = columns >> (2 * quarter_x + 8 * quarter_y);
  return ((own & 1) * 0x33) | ((own >> 1 & 1) * 0xCC) | ((own >> 4 & 1) * 0x3300) |
         ((own >> 5 & 1) * 0xCC00);
}

/// Columns two by two made into one, in their quarter.
std::uint64_t narrowed(std::uint64_t columns, std::uint32_t quarter_x, std::uint32_t quarter_y) {
  const auto any = [&](std::uint64_t four) -> std::uint64_t {
    return (columns & four) != 0 ? 1 : 0;
  };
  const std::uint64_t own = any(0x33) | any(0xCC) << 1 | any(0x3300) << 4 | any(0xCC00) << 5;
  return own << (2 * quarter_x + 8 * quarter_y);
}

/// Cells of the grid of a level that a band takes up.
std::uint64_t cells_of(const ColumnBand& band, std::uint32_t level) {
  const std::uint32_t shift = level + kColumnBits;
  const auto along = [&](std::size_t k) {
    return std::uint64_t{(band.to[k] >> shift) - (band.from[k] >> shift)} + 1;
  };
  return along(0) * along(1);
}

/// Finest grid in which a triangle of such bounds takes up no more cells than it may.
std::uint32_t grid_for(const ColumnBand& bounds) {
  std::uint32_t level = 0;
  while (cells_of(bounds, level) > kCellsATriangle) {
    ++level;
  }
  return level;
}

}  // namespace

MinMaxGrid::MinMaxGrid(std::span<const TriangleBlock> blocks, const Box& bounds, double scale,
                       const Limits& limits) {
  const Vec3 extent = bounds.extent();
  std::array<std::uint8_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint8_t a, std::uint8_t b) { return extent[a] > extent[b]; });
  if (blocks.empty() || !(extent[order[1]] > 0) || extent[order[2]] * kFlat > extent[order[1]]) {
    return;
  }
  plan_.axis = order;
  lay_plan(bounds, scale, blocks.size());
  cells_.resize(lay_grids());
  std::fill(cells_.own().begin(), cells_.own().end(), Cell{kInfinity, -kInfinity, 0});
  const Limits silent = limits.silent();
  limits.threads == 1 ? fill<false>(blocks, scale, silent) : fill<true>(blocks, scale, silent);
}

MinMaxGrid::MinMaxGrid(const GroundPlan& plan, std::span<const Cell> cells)
    : cells_(Stored<Cell>::borrowed(cells)), plan_(plan) {
  lay_grids();
}

std::size_t MinMaxGrid::count_cells(const GroundPlan& plan) {
  MinMaxGrid laid;
  laid.plan_ = plan;
  return laid.lay_grids();
}

bool MinMaxGrid::is_fit(const GroundPlan& plan) {
  const unsigned axes =
      1U << (plan.axis[0] & 3U) | 1U << (plan.axis[1] & 3U) | 1U << (plan.axis[2] & 3U);
  const auto in_range = [](double last) {
    return last >= 0 && last <= (1U << kColumnBits) * kMostCells && last == std::floor(last);
  };
  return std::max({plan.axis[0], plan.axis[1], plan.axis[2]}) < 3 && axes == 7 &&
         in_range(plan.last[0]) && in_range(plan.last[1]) && std::isfinite(plan.origin[0]) &&
         std::isfinite(plan.origin[1]) && std::isfinite(plan.columns_a_unit) &&
         plan.columns_a_unit > 0 && std::isfinite(plan.rounding) && plan.rounding >= 0;
}

void MinMaxGrid::lay_plan(const Box& bounds, double scale, std::size_t blocks) {
  const Vec3 extent = bounds.extent();
  const std::array<double, 2> sides = {extent[plan_.axis[0]] * scale,
                                       extent[plan_.axis[1]] * scale};
  const double cells = kCellsABlock * static_cast<double>(blocks);
  // By the longer side and the number of its cells, so that no product of sides is needed.
  const double row =
      std::clamp(std::sqrt(cells * (sides[0] / sides[1])), 1.0, std::min(cells, kMostCells));
  plan_.columns_a_unit = (1U << kColumnBits) * (row / sides[0]);
  plan_.rounding = 0x1p-45 * sides[0];
  for (std::size_t k = 0; k < 2; ++k) {
    plan_.origin[k] = -0.5 * sides[k];
    plan_.last[k] =
        std::floor(std::min(sides[k] * plan_.columns_a_unit, (1U << kColumnBits) * kMostCells));
  }
}

std::size_t MinMaxGrid::lay_grids() {
  const std::uint32_t width = (static_cast<std::uint32_t>(plan_.last[0]) >> kColumnBits) + 1;
  const std::uint32_t height = (static_cast<std::uint32_t>(plan_.last[1]) >> kColumnBits) + 1;
  std::size_t first = 0;
  for (std::uint32_t k = 0;; ++k) {
    Grid& here = grids_[grid_count_++];
    here = {first, ((width - 1) >> k) + 1, ((height - 1) >> k) + 1};
    first += std::size_t{here.width} * here.height;
    if (here.width == 1 && here.height == 1) {
      break;
    }
  }
  return first;
}

template <bool kShared>
void MinMaxGrid::fill(std::span<const TriangleBlock> blocks, double scale, const Limits& limits) {
  // Of equal heights the first one stays: none is -0, so that the order of threads does not show.
  const auto put_range = [](Cell& cell, std::uint32_t, std::uint32_t, const ColumnBand& band) {
    change<kShared>(cell.lower, [&](float now) { return std::min(now, band.lower + 0.0F); });
    change<kShared>(cell.upper, [&](float now) { return std::max(now, band.upper + 0.0F); });
  };
  for_each_block(blocks, scale, limits, [&](const BlockPlace& place, std::size_t count) {
    // Where a block is small, its triangles have about one range: slices tell them apart.
    const ColumnBand whole = place.whole();
    if (cells_of(whole, 0) <= kCellsOfSmall) {
      put_band(0, whole, put_range);
      return;
    }
    const BlockBands bands(place);
    for (std::size_t lane = 0; lane < count; ++lane) {
      put_triangle(bands, lane, put_range);
    }
  });
  hand_down([](Cell& fine, const Cell& coarse, std::uint32_t, std::uint32_t) {
    fine.lower = std::min(fine.lower, coarse.lower);
    fine.upper = std::max(fine.upper, coarse.upper);
  });
  hand_up([](const Cell& fine, Cell& coarse, std::uint32_t, std::uint32_t) {
    coarse.lower = std::min(coarse.lower, fine.lower);
    coarse.upper = std::max(coarse.upper, fine.upper);
  });
  const auto take_up = [](Cell& cell, std::uint32_t x, std::uint32_t y, const ColumnBand& band) {
    const auto ends = slice_ends(cell.lower, cell.upper);
    const std::uint64_t taken =
        mask_of(columns_of(x, band.from[0], band.to[0]), columns_of(y, band.from[1], band.to[1]),
                {slice_of(static_cast<double>(band.lower), ends),
                 slice_of(static_cast<double>(band.upper), ends)});
    change<kShared>(cell.taken, [=](std::uint64_t now) { return now | taken; });
  };
  for_each_block(blocks, scale, limits, [&](const BlockPlace& place, std::size_t count) {
    const BlockBands bands(place);
    for (std::size_t lane = 0; lane < count; ++lane) {
      put_triangle(bands, lane, take_up);
    }
  });
  hand_down([](Cell& fine, const Cell& coarse, std::uint32_t quarter_x, std::uint32_t quarter_y) {
    if (coarse.taken != 0) {
      const SliceMap map(coarse, fine);
      for (std::size_t slice = 0; slice < 4; ++slice) {
        fine.taken |=
            map.put(widened(columns_in(coarse.taken, slice), quarter_x, quarter_y), slice);
      }
    }
  });
  hand_up([](const Cell& fine, Cell& coarse, std::uint32_t quarter_x, std::uint32_t quarter_y) {
    if (fine.taken != 0) {
      const SliceMap map(fine, coarse);
      for (std::size_t slice = 0; slice < 4; ++slice) {
        coarse.taken |=
            map.put(narrowed(columns_in(fine.taken, slice), quarter_x, quarter_y), slice);
      }
    }
  });
}

template <class Put>
void MinMaxGrid::for_each_block(std::span<const TriangleBlock> blocks, double scale,
                                const Limits& limits, const Put& put) {
  for_each_chunk(blocks.size(), kChunk, limits, [&](std::size_t begin, std::size_t end) {
    for (const TriangleBlock& block : blocks.subspan(begin, end - begin)) {
      put(BlockPlace(block, scale, plan_), block.count);
    }
  });
}

template <class Put>
void MinMaxGrid::put_triangle(const BlockBands& bands, std::size_t lane, const Put& put) {
  const ColumnBand bounds = bands.band(lane);
  const std::uint32_t level = grid_for(bounds);
  const ColumnBand joined = bounds.joined(level);
  if (joined.few()) {
    put_band(level, joined, put);
  } else {
    for_each_band(bands.triangle(lane), joined, plan_, level,
                  [&](const ColumnBand& band) { put_band(level, band, put); });
  }
}

template <class Put>
void MinMaxGrid::put_band(std::uint32_t level, const ColumnBand& band, const Put& put) {
  const Grid& grid = grids_[level];
  for (std::uint32_t y = band.from[1] >> kColumnBits; y <= band.to[1] >> kColumnBits; ++y) {
    for (std::uint32_t x = band.from[0] >> kColumnBits; x <= band.to[0] >> kColumnBits; ++x) {
      put(cells_.own()[grid.first + std::size_t{y} * grid.width + x], x, y, band);
    }
  }
}

template <class Visit>
void MinMaxGrid::hand_down(const Visit& visit) {
  for (std::size_t k = grid_count_ - 1; k-- > 0;) {
    visit_grid(k, visit);
  }
}

template <class Visit>
void MinMaxGrid::hand_up(const Visit& visit) {
  for (std::size_t k = 0; k + 1 < grid_count_; ++k) {
    visit_grid(k, visit);
  }
}

template <class Visit>
void MinMaxGrid::visit_grid(std::size_t k, const Visit& visit) {
  const Grid& fine = grids_[k];
  const Grid& coarse = grids_[k + 1];
  for (std::uint32_t y = 0; y < fine.height; ++y) {
    Cell* const row = &cells_.own()[fine.first + std::size_t{y} * fine.width];
    Cell* const above = &cells_.own()[coarse.first + std::size_t{y >> 1} * coarse.width];
    for (std::uint32_t x = 0; x < fine.width; ++x) {
      visit(row[x], above[x >> 1], x & 1, y & 1);
    }
  }
}

bool MinMaxGrid::clear(const PlanBox& box) const {
  const auto span = [&](std::size_t k) {
    return (box.to[k] >> kColumnBits) - (box.from[k] >> kColumnBits);
  };
  const std::uint32_t most = std::max(span(0), span(1));
  // The finest grid in which that is two cells at most.
  const std::uint32_t level = most <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(most - 1));
  const Grid& grid = grids_[level];
  const std::array<std::uint32_t, 2> from = {box.from[0] >> level, box.from[1] >> level};
  const std::array<std::uint32_t, 2> to = {box.to[0] >> level, box.to[1] >> level};
  const std::uint32_t x0 = from[0] >> kColumnBits;
  const std::uint32_t x1 = to[0] >> kColumnBits;
  const std::uint32_t y0 = from[1] >> kColumnBits;
  const std::uint32_t y1 = to[1] >> kColumnBits;
  const Cell* const row0 = &cells_[grid.first + std::size_t{y0} * grid.width];
  const std::uint64_t along_x0 = kColumnsX.of(columns_of(x0, from[0], to[0]));
  const std::uint64_t along_y0 = kColumnsY.of(columns_of(y0, from[1], to[1]));
  if (x0 == x1 && y0 == y1) {
    return taken_by(row0[x0], along_x0 * along_y0, box) == 0;
  }
  // Four cells, even if two of them are the same: nothing depends on how many there are.
  const Cell* const row1 = &cells_[grid.first + std::size_t{y1} * grid.width];
  const std::uint64_t along_x1 = kColumnsX.of(columns_of(x1, from[0], to[0]));
  const std::uint64_t along_y1 = kColumnsY.of(columns_of(y1, from[1], to[1]));
  return (taken_by(row0[x0], along_x0 * along_y0, box) |
          taken_by(row0[x1], along_x1 * along_y0, box) |
          taken_by(row1[x0], along_x0 * along_y1, box) |
          taken_by(row1[x1], along_x1 * along_y1, box)) == 0;
}

}  // namespace soms::layout
