/// \file
/// What a splitting rule sees of a node, and what it answers.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <limits>
#include <span>

namespace soms {

/// A triangle as splitting rules see it.
struct Primitive {
  Box bounds;         ///< of its corners
  Vec3 midpoint;      ///< the point that stands for it
  TriangleId id = 0;  ///< its number in the mesh
};

/// A node that is to be divided.
struct SplitNode {
  std::span<const Primitive> primitives;  ///< at least 2, in ascending order of `id`
  Box outer;                              ///< bounds of all corners
  Box inner;                              ///< bounds of the midpoints
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
