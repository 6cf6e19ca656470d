/// \file
/// Which of many boxes meet each other? For boxes that all may have moved: nothing is kept but
/// memory.
#pragma once

#include "soms/base/box.h"
#include "soms/scene/detail/box_index.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// All pairs of meeting boxes from scratch, by columns and a sweep: every box enters the columns
/// that it meets along one axis, each column is swept along another, and a pair belongs to the
/// column where its overlap begins. Boxes far wider than a column ask a `BoxIndex` instead, so one
/// slab under a thousand cars costs a thousand answers and no more.
class MovingPairs {
 public:
  /// Pairs `(a, b)`, `a` less than `b`, of boxes that share a point, sorted. The span is valid
  /// until the next call. Empty boxes meet nothing.
  /// \cost  O(n log n) and the boxes that share a column and a stretch of the sweep; memory is
  ///        reused.
  std::span<const std::pair<std::uint32_t, std::uint32_t>> find(std::span<const Box> boxes);

  [[nodiscard]] std::size_t memory() const {
    return bytes(ranges_) + bytes(entries_) + bytes(wide_) + bytes(is_wide_) + bytes(pairs_) +
           index_.memory();
  }

 private:
  /// The grid of one call: columns along `across`, the sweep along `along`.
  struct Grid {
    std::size_t across = 0;
    std::size_t along = 1;
    double column_origin = 0;
    double column_scale = 0;  ///< columns a metre
    double sweep_origin = 0;
    double sweep_scale = 0;  ///< steps a metre
    std::uint32_t columns = 1;

    [[nodiscard]] std::uint32_t column(double value) const;
    [[nodiscard]] std::uint32_t step(double value) const;
  };

  /// Where a box lies in the grid.
  struct Range {
    std::uint32_t first_column = 0;
    std::uint32_t last_column = 0;
    std::uint32_t last_step = 0;
  };

  [[nodiscard]] static Grid choose_grid(std::span<const Box> boxes);
  void enter(std::span<const Box> boxes, const Grid& grid);
  void sweep(std::span<const Box> boxes);
  void ask_for_wide(std::span<const Box> boxes);

  std::vector<Range> ranges_;
  std::vector<std::uint64_t> entries_;  ///< column (16 bits), first step (16), box (32)
  std::vector<std::uint32_t> wide_;
  std::vector<std::uint8_t> is_wide_;
  BoxIndex index_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace soms::detail
