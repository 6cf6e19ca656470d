/// \file
/// Which of many boxes meet a given box, or are nearest? For boxes that stay where they are.
#pragma once

#include "soms/base/box.h"
#include "soms/scene/detail/kept_memory.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace soms::detail {

/// A box, or the bounds of several, and its key in a search.
struct KeyedBounds {
  double key = 0;
  std::uint32_t level = 0;
  std::uint32_t number = 0;  ///< in its level
};

/// An immutable tree without pointers: the boxes by size and along a space-filling curve, bounds
/// over groups of eight, over groups of eight of those, and so on. Its depth depends on the number
/// of boxes alone, so no arrangement of boxes makes it deep.
class BoxIndex {
 public:
  /// Replaces the content. Box `k` is called `k` in answers; empty boxes meet nothing. With
  /// `groups` a query may pass over the boxes of one; boxes behind their end are of group 0.
  /// \cost  O(n log n); memory is reused, and given back where it is far more than is needed.
  void build(std::span<const Box> boxes, std::span<const std::uint32_t> groups = {});

  /// Calls `found(k)` for every box `k` that shares a point with `box`, in no order of `k`.
  template <typename Found>
  void query(const Box& box, Found&& found) const {
    visit<false>(box, 0, found);
  }

  /// The same without the boxes of `group`, unless that is 0. Where all boxes below a node are of
  /// this group it is not descended, so boxes that coincide cost nothing.
  /// \pre The content was built with groups.
  template <typename Found>
  void query(const Box& box, std::uint32_t group, Found&& found) const {
    visit<true>(box, group, found);
  }

  /// Calls `found(k, key)` for boxes `k` in the order of their keys, the least first, as long as
  /// keys are at most `limit`, which every call replaces by what it returns. `key_of(box)` is below
  /// infinity if the box matters, and not above the key of any box inside it. `heap` is memory.
  /// \return The number of boxes that were given a key.
  template <typename KeyOf, typename Found>
  std::uint64_t search(const KeyOf& key_of, double limit, std::vector<KeyedBounds>& heap,
                       Found&& found) const;

  [[nodiscard]] std::size_t memory() const {
    return bytes(order_) + bytes(bounds_) + bytes(groups_) + bytes(levels_) + bytes(keys_) +
           bytes(ranks_);
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
  void unite_groups(std::span<const std::uint32_t> groups);

  template <bool kGrouped, typename Found>
  void visit(const Box& box, std::uint32_t group, Found&& found) const;

  std::vector<std::uint32_t> order_;   ///< names of the boxes of level 0
  std::vector<Box> bounds_;            ///< level 0, then the levels above it
  std::vector<std::uint32_t> groups_;  ///< of `bounds_`: of all boxes below; 0 where they differ
  std::vector<Level> levels_;

  // Scratch of `build`: boxes with their keys; places of boxes with their coordinates.
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys_;
  std::vector<std::pair<double, std::uint32_t>> ranks_;
};

template <typename KeyOf, typename Found>
std::uint64_t BoxIndex::search(const KeyOf& key_of, double limit, std::vector<KeyedBounds>& heap,
                               Found&& found) const {
  const auto is_after = [](const KeyedBounds& a, const KeyedBounds& b) { return a.key > b.key; };
  std::uint64_t keyed = 0;
  heap.clear();
  const auto add = [&](std::size_t level, std::size_t begin, std::size_t end) {
    keyed += end - begin;
    for (std::size_t k = begin; k < end; ++k) {
      const double key = key_of(bounds_[levels_[level].first + k]);
      if (key <= limit && key < std::numeric_limits<double>::infinity()) {
        heap.push_back({key, static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(k)});
        std::push_heap(heap.begin(), heap.end(), is_after);
      }
    }
  };
  if (!levels_.empty()) {
    add(levels_.size() - 1, 0, 1);
  }
  while (!heap.empty() && heap.front().key <= limit) {
    std::pop_heap(heap.begin(), heap.end(), is_after);
    const KeyedBounds next = heap.back();
    heap.pop_back();
    if (next.level == 0) {
      limit = found(order_[next.number], next.key);
    } else {
      const std::size_t begin = std::size_t{next.number} * kGroup;
      add(next.level - 1, begin, std::min(begin + kGroup, levels_[next.level - 1].count));
    }
  }
  return keyed;
}

template <bool kGrouped, typename Found>
void BoxIndex::visit(const Box& box, std::uint32_t group, Found&& found) const {
  const auto passed_over = [&](std::size_t number) {
    return kGrouped && group != 0 && groups_[number] == group;
  };
  if (levels_.size() <= 1) {
    if (!levels_.empty() && !passed_over(0) && overlaps(bounds_[0], box)) {
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
    const std::size_t number = level.first + visit.number;
    if (passed_over(number) || !overlaps(bounds_[number], box)) {
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
