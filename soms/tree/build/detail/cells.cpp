#include "soms/tree/build/detail/cells.h"

#include "soms/base/parallel.h"
#include "soms/tree/layout/detail/refit_layout.h"
#include "soms/tree/layout/detail/widen.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::detail {

namespace {

using lanes::Box4;
using lanes::F4;

constexpr std::size_t kChunk = 32768;
constexpr std::size_t kBins = 32;
/// Middles within less are as one: what scales them to cells or bins would be subnormal or endless.
constexpr float kLeastExtent = 0x1p-100F;

/// Cells along the longest side are a power of two, such that a surface has about this many
/// triangles in each cell that it passes.
constexpr double kTrianglesInCell = 100;
constexpr int kMostBits = 6;

/// Two zeros before each of six bits.
constexpr std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 8) & 0x0300fU;
  x = (x | x << 4) & 0x030c3U;
  return (x | x << 2) & 0x09249U;
}

/// The grid: cubes over the box of the middles.
class Grid {
 public:
  Grid(const PrimitiveRange& all, std::size_t count) : lower_(all.middles.lower) {
    const F4 extent = all.middles.upper - all.middles.lower;
    const float size = std::max({extent[0], extent[1], extent[2]});
    const double cells = static_cast<double>(count) / kTrianglesInCell;
    bits_ = std::clamp(static_cast<int>(std::lround(0.5 * std::log2(cells))), 1, kMostBits);
    const float side = static_cast<float>(1 << bits_);
    scale_ = size > kLeastExtent ? side * (1 - 0x1p-20F) / size : 0;
    most_half_ = size / side;
  }

  /// One key for each cell, in Morton order, and one more for all that is larger than cells.
  [[nodiscard]] std::size_t keys() const { return (std::size_t{1} << 3 * bits_) + 1; }

  [[nodiscard]] std::uint32_t key(const Reference& r) const {
    const F4 half_extent = r.half_extent();
    if (std::max({half_extent[0], half_extent[1], half_extent[2]}) > most_half_) {
      return static_cast<std::uint32_t>(keys() - 1);
    }
    const F4 place = (r.point() - lower_) * lanes::splat(scale_);
    return spread(static_cast<std::uint32_t>(place[0])) |
           spread(static_cast<std::uint32_t>(place[1])) << 1 |
           spread(static_cast<std::uint32_t>(place[2])) << 2;
  }

 private:
  F4 lower_;
  float scale_ = 0;
  float most_half_ = 0;
  int bits_ = 0;
};

/// Counts keys in a few large chunks, so that each has a table of its own.
struct Chunks {
  std::size_t size;
  std::size_t number;

  explicit Chunks(std::size_t count)
      : size(std::max<std::size_t>((count + 7) / 8, 1)), number((count - 1) / size + 1) {}
};

layout::Pages<Reference> scattered(const layout::Pages<Reference>& references, const Grid& grid,
                                   const Limits& limits) {
  const std::size_t count = references.size();
  const Chunks chunks(count);
  layout::Pages<std::uint32_t> keys;
  keys.resize(count);
  std::vector<std::vector<std::uint32_t>> places(chunks.number);
  for_each_chunk(count, chunks.size, limits, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& counts = places[begin / chunks.size];
    counts.assign(grid.keys(), 0);
    for (std::size_t i = begin; i < end; ++i) {
      keys[i] = grid.key(references[i]);
      ++counts[keys[i]];
    }
  });
  std::uint32_t next = 0;
  for (std::size_t key = 0; key < grid.keys(); ++key) {
    for (std::vector<std::uint32_t>& place : places) {
      const std::uint32_t n = place[key];
      place[key] = next;
      next += n;
    }
  }
  layout::Pages<Reference> sorted;
  sorted.resize(count);
  for_each_chunk(count, chunks.size, limits, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& place = places[begin / chunks.size];
    for (std::size_t i = begin; i < end; ++i) {
      sorted[place[keys[i]]++] = references[i];
    }
  });
  return sorted;
}

void add(Cell& cell, const Reference& r) {
  cell.range.add(r);
  cell.box.grow(r.point() - r.half_extent(), r.point() + r.half_extent());
}

/// Cells and large ones; the order of the references tells where one ends.
std::vector<Cell> cells_of(const layout::Pages<Reference>& sorted, const Grid& grid) {
  std::vector<Cell> cells;
  std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
  const auto large = static_cast<std::uint32_t>(grid.keys() - 1);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::uint32_t key = grid.key(sorted[i]);
    if (key != last || key == large) {
      last = key;
      cells.emplace_back();
      cells.back().range.first = static_cast<std::uint32_t>(i);
    }
    add(cells.back(), sorted[i]);
  }
  return cells;
}

struct Bin {
  Box4 box;
  std::uint32_t count = 0;
};

/// Cells by where their middles lie, on each axis.
struct Histogram {
  std::array<std::array<Bin, kBins>, 3> bins;
  F4 lower;                    ///< twice the least middle
  F4 scale = lanes::splat(0);  ///< to bins; 0 where all middles agree
  std::uint32_t triangles = 0;

  explicit Histogram(std::span<const Cell> cells) {
    Box4 middles;
    for (const Cell& cell : cells) {
      middles.grow(cell.box.lower + cell.box.upper);
    }
    lower = middles.lower;
    const F4 extent = middles.upper - lower;
    for (std::size_t k = 0; k < 3; ++k) {
      scale[k] =
          extent[k] > kLeastExtent ? static_cast<float>(kBins) * (1 - 0x1p-20F) / extent[k] : 0;
    }
    for (const Cell& cell : cells) {
      triangles += cell.range.count;
      for (std::size_t k = 0; k < 3; ++k) {
        Bin& bin = bins[k][bin_of(cell, k)];
        bin.box.grow(cell.box);
        bin.count += cell.range.count;
      }
    }
  }

  [[nodiscard]] std::size_t bin_of(const Cell& cell, std::size_t axis) const {
    const F4 place = (cell.box.lower + cell.box.upper - lower) * scale;
    return static_cast<std::size_t>(static_cast<std::int32_t>(place[axis]));
  }
};

struct Candidate {
  float cost = std::numeric_limits<float>::infinity();
  std::size_t axis = 0;
  std::size_t first_right = 0;  ///< a bin; 0 when nothing was found
};

/// The cheapest bound between bins of an axis that beats `best`.
void improve(Candidate& best, const Histogram& h, std::size_t axis) {
  const auto& bins = h.bins[axis];
  std::array<float, kBins> right;
  Box4 box;
  std::uint32_t count = 0;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    box.grow(bins[i].box);
    count += bins[i].count;
    right[i] = count > 0 ? box.half_area() * static_cast<float>(count) : 0;
  }
  box = Box4{};
  count = 0;
  for (std::size_t i = 1; i < kBins; ++i) {
    box.grow(bins[i - 1].box);
    count += bins[i - 1].count;
    const float cost = box.half_area() * static_cast<float>(count) + right[i];
    if (count > 0 && count < h.triangles && cost < best.cost) {
      best = {cost, axis, i};
    }
  }
}

}  // namespace

Cells sort_into_cells(const MeshView& mesh, const Limits& limits) {
  const Limits quiet = limits.silent();
  const Box bounds = layout::bounds_of(mesh, quiet);
  const PrimitiveFrame frame = frame_of(bounds);
  const std::size_t count = mesh.triangles.size();
  layout::Pages<Reference> references;
  references.resize(count);
  std::vector<PrimitiveRange> ranges((count - 1) / kChunk + 1);
  for_each_chunk(count, kChunk, quiet, [&](std::size_t begin, std::size_t end) {
    PrimitiveRange range;
    for (std::size_t i = begin; i < end; ++i) {
      references[i] = reference_of(mesh, static_cast<TriangleId>(i), frame);
      range.add(references[i]);
    }
    ranges[begin / kChunk] = range;
  });
  PrimitiveRange all;
  for (const PrimitiveRange& range : ranges) {
    all.middles.grow(range.middles);
  }
  if (count <= layout::kPartTriangles) {
    Cells whole;
    whole.bounds = bounds;
    whole.cells.emplace_back();
    for (const Reference& r : references) {
      add(whole.cells.back(), r);
    }
    whole.references = std::move(references);
    whole.spare.resize(count);
    return whole;
  }
  const Grid grid(all, count);
  Cells result{bounds, scattered(references, grid, quiet), {}, {}};
  result.spare = std::move(references);
  result.cells = cells_of(result.references, grid);
  return result;
}

std::size_t divide_cells(std::span<Cell> cells) {
  const Histogram h(cells);
  Candidate best;
  for (std::size_t k = 0; k < 3; ++k) {
    improve(best, h, k);
  }
  if (best.first_right == 0) {
    return cells.size() / 2;  // all middles are one
  }
  const auto middle = std::stable_partition(cells.begin(), cells.end(), [&](const Cell& cell) {
    return h.bin_of(cell, best.axis) < best.first_right;
  });
  return static_cast<std::size_t>(middle - cells.begin());
}

}  // namespace soms::detail
