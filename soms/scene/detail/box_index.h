/// \file
/// Which of many boxes meet a given box? For boxes that stay where they are.
#pragma once

#include "soms/base/box.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// Bytes that a vector holds for its values.
template <typename Value>
[[nodiscard]] std::size_t bytes(const std::vector<Value>& values) {
  return values.capacity() * sizeof(Value);  // NOLINT(bugprone-sizeof-expression): pointers, too
}

/// An immutable tree without pointers: the boxes by size and along a space-filling curve, bounds
/// over groups of eight, over groups of eight of those, and so on. Its depth depends on the number
/// of boxes alone, so no arrangement of boxes makes it deep.
class BoxIndex {
 public:
  /// Replaces the content. Box `k` is called `k` in answers; empty boxes meet nothing.
  /// \cost  O(n log n); memory is reused.
  void build(std::span<const Box> boxes);

  /// Calls `found(k)` for every box `k` that shares a point with `box`, in no order of `k`.
  template <typename Found>
  void query(const Box& box, Found&& found) const;

  [[nodiscard]] std::size_t memory() const {
    return bytes(order_) + bytes(bounds_) + bytes(levels_) + bytes(keys_) + bytes(ranks_);
  }

 private:
  static constexpr std::uint32_t kGroup = 8;
  static constexpr std::size_t kMostLevels = 12;  // 8^11 is above 2^32

  struct Level {
    std::size_t first = 0;  ///< of the level's boxes in `bounds_`
    std::size_t count = 0;
  };

  struct Visit {
    std::uint32_t level = 0;
    std::uint32_t number = 0;  ///< in its level
  };

  void make_keys(std::span<const Box> boxes);

  std::vector<std::uint32_t> order_;  ///< names of the boxes of level 0
  std::vector<Box> bounds_;           ///< level 0, then the levels above it
  std::vector<Level> levels_;

  // Scratch of `build`: boxes with their keys; places of boxes with their coordinates.
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys_;
  std::vector<std::pair<double, std::uint32_t>> ranks_;
};

template <typename Found>
void BoxIndex::query(const Box& box, Found&& found) const {
  if (levels_.size() <= 1) {
    if (!levels_.empty() && overlaps(bounds_[0], box)) {
      found(order_[0]);
    }
    return;
  }
  // Each level leaves at most seven siblings behind.
  std::array<Visit, kGroup * kMostLevels> stack;
  std::size_t size = 0;
  stack[size++] = {static_cast<std::uint32_t>(levels_.size() - 1), 0};
  while (size > 0) {
    const Visit visit = stack[--size];
    const Level& level = levels_[visit.level];
    if (!overlaps(bounds_[level.first + visit.number], box)) {
      continue;
    }
    if (visit.level == 0) {
      found(order_[visit.number]);
      continue;
    }
    const std::size_t begin = std::size_t{visit.number} * kGroup;
    const std::size_t end = std::min(begin + kGroup, levels_[visit.level - 1].count);
    for (std::size_t child = end; child-- > begin;) {
      stack[size++] = {visit.level - 1, static_cast<std::uint32_t>(child)};
    }
  }
}

}  // namespace soms::detail
