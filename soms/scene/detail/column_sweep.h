/// \file
/// Which of many boxes meet each other? From scratch, by a column sweep.
#pragma once

#include "soms/scene/detail/column_grid.h"
#include "soms/scene/detail/float_box.h"
#include "soms/scene/detail/kernels/sweep.h"
#include "soms/scene/detail/pair_filter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace soms::detail {

/// All pairs of meeting boxes: a grid over two axes, every box in each column that it meets, one
/// radix sort by column and start on the third axis, then a sweep of each column, several boxes at
/// a time. A pair belongs to the column where its overlap begins. A box of very many columns is
/// compared with all others instead.
class ColumnSweep {
 public:
  ColumnSweep() = default;

  explicit ColumnSweep(SweepKernel kernel) : kernel_(kernel) {}

  /// Pairs as `a << 32 | b`, `a` less than `b`, each once, in no order, without those that `filter`
  /// leaves out. Those without `kOpenPair` meet as floats and share no end; of the others a few
  /// are apart.
  /// Empty boxes (`kNoBox`) are left out. Nothing if the boxes do not suit a grid, so that work
  /// would be out of proportion to boxes and pairs: then nearly all lie in few columns.
  /// The span is valid until the next call.
  /// \pre   At most `kMostBoxes` boxes.
  /// \cost  O(n), n boxes, and the boxes that share a column and a stretch of the sweep; memory is
  ///        reused.
  [[nodiscard]] std::optional<std::span<std::uint64_t>> find(std::span<const FloatBox> boxes,
                                                             const PairFilter& filter = {});

  /// Gives back memory that is far more than the last call needed; its pairs are gone.
  void give_back();

  /// Work of the last call: about the boxes that it could have entered in the grid in that time.
  [[nodiscard]] std::uint64_t work() const { return entered_ + compared_ / 32; }

  [[nodiscard]] std::size_t memory() const;

  /// Entries, of which boxes have several, are counted in 32 bits.
  static constexpr std::size_t kMostBoxes = std::size_t{1} << 27;

 private:
  [[nodiscard]] bool enter(std::span<const FloatBox> boxes);
  void sort();
  void arrange(std::span<const FloatBox> boxes);
  void arrange_groups(const PairFilter& filter);
  [[nodiscard]] std::size_t without_ignored(std::size_t begin, std::size_t end,
                                            const PairFilter& filter);
  void report(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] std::size_t memory_of_sweep() const;
  [[nodiscard]] bool sweep(const PairFilter& filter);
  [[nodiscard]] bool compare_wide(std::span<const FloatBox> boxes, const PairFilter& filter);

  SweepKernel kernel_ = nullptr;  ///< none: that of the instruction set that queries run on
  ColumnGrid grid_;
  std::vector<std::uint64_t> entries_;  ///< key (32 bits), begins here (2), box (30)
  std::vector<std::uint64_t> scratch_;
  std::vector<std::uint32_t> wide_;
  std::vector<std::uint64_t> pairs_;

  // Of the entries, in order, and one block behind them.
  std::vector<std::int32_t> keys_;          ///< column, then start
  std::vector<std::int32_t> last_keys_;     ///< column, then end
  std::vector<std::uint32_t> names_;        ///< begins here (2 bits), box (30)
  std::array<std::vector<float>, 4> ends_;  ///< across: lower, upper; upward: lower, upper
  std::vector<std::int32_t> groups_;        ///< bits of the group; filled where there are any

  std::size_t found_ = 0;
  std::size_t entered_ = 0;
  std::uint64_t compared_ = 0;
  std::uint64_t most_compared_ = 0;
};

}  // namespace soms::detail
