/// \file
/// Where a mesh that lies flat, such as a city, reaches above each place of its ground plan. What
/// flies above it, drives below a bridge's deck but beside its piers, or stands in a yard is known
/// to be clear by a look at four cells.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/vector.h"
#include "soms/tree/layout/detail/ground_plan.h"
#include "soms/tree/layout/detail/stored.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms {

struct Box;
struct TriangleBlock;

namespace layout {

class BlockBands;
struct ColumnBand;

/// A grid over the two longer axes of a mesh's box, about six triangles a cell, and coarser ones
/// above it, each cell of which is four of the grid below. A cell holds the least and the greatest
/// third coordinate of what reaches into it, and which of its 4 x 4 columns are taken up in which
/// of four slices of that range.
///
/// All coordinates are in units of the layout, relative to the tree's origin.
///
/// Proof. By column_bands.h every point of a triangle lies in a column of one of its bands, and
/// between that band's heights. Bands are put into the finest grid in which the triangle's bounds
/// take up at most 64 cells. What is in a grid is handed down to all finer ones, and then up to all
/// coarser ones: ranges first, then, once they are final, the slices. A height's slice is found by
/// comparing it with three numbers of its cell, which is monotone in it; so a point in a slice of
/// one grid lies between the slices of that slice's ends in another. So in each grid the column and
/// slice of the point are marked, and a box that holds the point covers both.
class MinMaxGrid {
 public:
  struct Cell {
    float lower;
    float upper;
    std::uint64_t taken;  ///< columns and slices: see height_mask.h

    [[nodiscard]] bool operator==(const Cell&) const = default;
  };

  /// An empty grid: nothing is known to be clear.
  MinMaxGrid() = default;

  /// The grids of a plan over cells that something else holds.
  /// \pre `plan` is fit for grids, and `cells` are `count_cells(plan)`.
  MinMaxGrid(const GroundPlan& plan, std::span<const Cell> cells);

  /// How many cells the grids of a plan have. \pre `is_fit(plan)`
  [[nodiscard]] static std::size_t count_cells(const GroundPlan& plan);

  /// True if grids may be laid over the plan: its axes are three, and its numbers are in range.
  [[nodiscard]] static bool is_fit(const GroundPlan& plan);

  /// The grid of the triangles of `blocks`, or none where their box, in the mesh's units, is not
  /// flat: its least side is more than a quarter of the next. The same bytes for any number of
  /// threads. \errors cancelled. \cost O(n) time; 4 bytes a triangle.
  MinMaxGrid(std::span<const TriangleBlock> blocks, const Box& bounds, double scale,
             const Limits& limits);

  [[nodiscard]] bool empty() const { return cells_.empty(); }

  /// True only if no triangle has a point in the box.
  /// \pre not empty; the box is of `plan()`
  [[nodiscard]] bool clear(const PlanBox& box) const;

  /// Four columns a cell of the finest grid along each axis.
  [[nodiscard]] const GroundPlan& plan() const { return plan_; }

  /// Those of all grids, finest first.
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }

  [[nodiscard]] bool operator==(const MinMaxGrid&) const = default;

  [[nodiscard]] std::size_t memory() const { return cells_.memory(); }

 private:
  /// One grid, finest first.
  struct Grid {
    std::size_t first = 0;  ///< of its cells in `cells_`
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    [[nodiscard]] bool operator==(const Grid&) const = default;
  };

  static constexpr std::size_t kMostGrids = 32;

  void lay_plan(const Box& bounds, double scale, std::size_t blocks);
  /// Returns how many cells all grids have.
  std::size_t lay_grids();

  /// \tparam kShared several threads fill
  template <bool kShared>
  void fill(std::span<const TriangleBlock> blocks, double scale, const Limits& limits);

  /// Calls `put` with the place of each block and the number of its triangles.
  template <class Put>
  void for_each_block(std::span<const TriangleBlock> blocks, double scale, const Limits& limits,
                      const Put& put);

  /// Calls `put` with each cell of a triangle's bands, or of one band.
  template <class Put>
  void put_triangle(const BlockBands& bands, std::size_t lane, const Put& put);
  template <class Put>
  void put_band(std::uint32_t level, const ColumnBand& band, const Put& put);

  /// Calls `visit` with each cell but the coarsest, the cell above it, and which of that one's
  /// quarters it is: from the coarsest grid down, or from the finest up.
  template <class Visit>
  void hand_down(const Visit& visit);
  template <class Visit>
  void hand_up(const Visit& visit);
  template <class Visit>
  void visit_grid(std::size_t k, const Visit& visit);

  Stored<Cell> cells_;
  std::array<Grid, kMostGrids> grids_ = {};
  std::size_t grid_count_ = 0;
  GroundPlan plan_;
};

}  // namespace layout
}  // namespace soms
