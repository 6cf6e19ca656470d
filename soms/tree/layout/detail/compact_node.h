/// \file
/// Nodes for shapes that must be small: what `WideNode` says, with boxes in bytes.
#pragma once

#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms {

/// A node of four boxes whose sides are whole steps from the node's origin. Place and axes are the
/// wide node's; boxes are rounded outward to the steps, so they hold the wide node's. Steps have 15
/// bits, so whatever is read is exact. A leaf's token holds the number of its first entry in
/// `CompactParts::ids`.
struct alignas(64) CompactNode {
  static constexpr std::uint32_t kWidth = WideNode::kWidth;

  std::array<std::array<std::int8_t, kWidth>, 3> lower = {};  ///< axis, lane; in steps
  std::array<std::array<std::int8_t, kWidth>, 3> upper = {};
  std::array<float, 3> step = {};
  std::array<std::uint32_t, kWidth> child = {};
  std::array<double, 3> origin = {};
  layout::Axes axes = layout::kMeshAxes;
  float l1_radius = 0;
  std::uint8_t count = 0;
  std::uint8_t leaves = 0;
  std::uint8_t oriented = 0;

  CompactNode() = default;

  /// Rounds a node's boxes outward; `child` is the caller's.
  explicit CompactNode(const WideNode& from);

  /// Writes the node as queries traverse it.
  void read(WideNode& node) const;

  [[nodiscard]] bool operator==(const CompactNode&) const = default;
};

static_assert(sizeof(CompactNode) == 128 && alignof(CompactNode) == 64, "two cache lines");

}  // namespace soms
