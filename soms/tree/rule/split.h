/// \file
/// What a splitting rule sees of a node, and what it answers.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace soms {

/// A triangle as splitting rules see it, in one cache line.
struct alignas(64) Primitive {
  /// The point that stands for it.
  std::array<double, 3> midpoint = {};
  /// Its number in the mesh.
  TriangleId id = 0;
  /// How far its box reaches below and above the midpoint, rounded to float, in units of
  /// SplitNode::unit. Good for costs only; lane 3 is 0.
  std::array<float, 4> below = {};
  std::array<float, 4> above = {};
};

static_assert(sizeof(Primitive) == 64);

/// A node that is to be divided.
struct SplitNode {
  std::span<const Primitive> primitives;  ///< at least 2; their order is RuleEntry::needs_order's
  Box inner;                              ///< bounds of the midpoints
  Box outer;                              ///< bounds of all corners, for rules that need them
  double unit = 1;                        ///< a power of two near the size of the mesh
};

/// How a node is divided: left are the primitives whose midpoint on `axis` lies below `value`, and
/// of those with exactly this midpoint the ones numbered below `id`. A plane has `id` 0, so what
/// lies on it goes right.
struct Split {
  std::size_t axis = 0;
  double value = -std::numeric_limits<double>::infinity();
  TriangleId id = 0;

  [[nodiscard]] bool is_left(const Primitive& p) const {
    const double m = p.midpoint[axis];
    return m < value || (m == value && p.id < id);
  }
};

/// A splitting rule: a function of the node and of the axis that the options chose for it. A split
/// that leaves one side empty says that the rule cannot divide the node on this axis.
using RuleFunction = Split (*)(const SplitNode& node, std::size_t axis);

}  // namespace soms
