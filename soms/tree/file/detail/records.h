/// \file
/// Records of a layout as bytes of which each is determined.
#pragma once

#include "soms/tree/layout/detail/compact_node.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>

namespace soms::detail {

/// Bytes between the members of a record, which nothing writes.
struct Gap {
  std::size_t begin;
  std::size_t end;
};

inline constexpr Gap kGapsOfWideNode[] = {{offsetof(WideNode, oriented) + 1, sizeof(WideNode)}};
static_assert(offsetof(WideNode, center) == 0 && offsetof(WideNode, half) == 48 &&
              offsetof(WideNode, row) == 96 && offsetof(WideNode, child) == 144 &&
              offsetof(WideNode, origin) == 160 && offsetof(WideNode, l1_radius) == 184 &&
              offsetof(WideNode, count) == 188 && offsetof(WideNode, leaves) == 189 &&
              offsetof(WideNode, oriented) == 190);

inline constexpr Gap kGapsOfCompactNode[] = {
    {52, offsetof(CompactNode, origin)},
    {offsetof(CompactNode, oriented) + 1, sizeof(CompactNode)}};
static_assert(offsetof(CompactNode, lower) == 0 && offsetof(CompactNode, upper) == 12 &&
              offsetof(CompactNode, step) == 24 && offsetof(CompactNode, child) == 36 &&
              offsetof(CompactNode, origin) == 56 && offsetof(CompactNode, axes) == 80 &&
              offsetof(CompactNode, l1_radius) == 116 && offsetof(CompactNode, count) == 120 &&
              offsetof(CompactNode, leaves) == 121 && offsetof(CompactNode, oriented) == 122);

template <class T>
[[nodiscard]] constexpr std::span<const Gap> gaps_of() {
  if constexpr (std::is_same_v<T, WideNode>) {
    return kGapsOfWideNode;
  } else if constexpr (std::is_same_v<T, CompactNode>) {
    return kGapsOfCompactNode;
  } else {
    return {};
  }
}

static_assert(sizeof(TriangleBlock) == offsetof(TriangleBlock, upper) + 8, "no gaps");
static_assert(sizeof(layout::MinMaxGrid::Cell) == 16, "no gaps");

/// The record's bytes, the gaps 0.
template <class T>
void copy_record(const T& record, std::byte* to) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(to, &record, sizeof(T));
  for (const Gap& gap : gaps_of<T>()) {
    std::memset(to + gap.begin, 0, gap.end - gap.begin);
  }
}

}  // namespace soms::detail
