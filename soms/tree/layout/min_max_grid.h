/// \file
/// How far down and up a mesh that lies flat, such as a city, reaches at each place of its ground
/// plan. What flies above it, drives below a bridge's deck but beside its piers, or stands in a
/// yard is known to be clear by a look at four numbers.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/vector.h"
#include "soms/tree/layout/pages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace soms {

struct Box;
struct TriangleBlock;

namespace layout {

/// A grid over the two longer axes of a mesh's box, about four triangles a cell, and coarser ones
/// above it, each cell of which is four of the grid below. A cell holds the least and the greatest
/// third coordinate of all triangles whose bounds reach into it.
///
/// All coordinates are in units of the layout, relative to the tree's origin.
///
/// Proof. A coordinate's cell is found by steps of which each is monotone in it, rounding included:
/// less a number, times a positive one, cut to a range, cut to an integer. So intervals that share
/// a number have a cell in common, and so have they in a coarser grid, whose cells are those of the
/// finest one divided by a power of two. A triangle is put into every cell that its bounds reach
/// into of the finest grid in which these are at most four; what is in a grid is handed down to all
/// finer ones, and then up to all coarser ones. So a cell of any grid knows all that reaches into
/// it.
class MinMaxGrid {
 public:
  /// An empty grid: nothing is known to be clear.
  MinMaxGrid() = default;

  /// The grid of the triangles of `blocks`, or none where their box, in the mesh's units, is not
  /// flat: its least side is more than a quarter of the next. The same bytes for any number of
  /// threads. \errors cancelled. \cost O(n) time; 3 bytes a triangle.
  MinMaxGrid(std::span<const TriangleBlock> blocks, const Box& bounds, double scale,
             const Parallel& parallel);

  [[nodiscard]] bool empty() const { return ranges_.empty(); }

  /// True only if no triangle has a point in the box `center +- half`.
  /// \pre not empty
  [[nodiscard]] bool clear(const std::array<double, 3>& center,
                           const std::array<double, 3>& half) const;

  [[nodiscard]] bool operator==(const MinMaxGrid&) const = default;

  [[nodiscard]] std::size_t memory() const { return ranges_.capacity() * sizeof(Range); }

 private:
  struct Range {
    float lower;
    float upper;

    [[nodiscard]] bool operator==(const Range&) const = default;
  };

  /// One grid, finest first.
  struct Grid {
    std::size_t first = 0;  ///< of its cells in `ranges_`
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    [[nodiscard]] bool operator==(const Grid&) const = default;
  };

  static constexpr std::size_t kMostGrids = 32;

  /// Cell of the finest grid along axis k of the ground plan.
  [[nodiscard]] std::uint32_t cell(std::size_t k, double x) const {
    const double place = (x - corner_[k]) * cells_a_unit_;
    return static_cast<std::uint32_t>(place > 0 ? (place < last_[k] ? place : last_[k]) : 0);
  }

  void lay_grids(const Box& bounds, double scale, std::size_t blocks);
  template <bool kShared>
  void put(std::span<const TriangleBlock> blocks, double scale);
  void hand_down();
  void hand_up();

  Pages<Range> ranges_;
  std::array<Grid, kMostGrids> grids_ = {};
  std::size_t grid_count_ = 0;
  std::array<std::uint8_t, 3> axis_ = {};  ///< the two of the ground plan, and the least
  std::array<double, 2> corner_ = {};      ///< of the ground plan
  std::array<double, 2> last_ = {};        ///< number of the last cell of a row, of a column
  double cells_a_unit_ = 0;
};

}  // namespace layout
}  // namespace soms
