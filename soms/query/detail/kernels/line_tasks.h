/// \file
/// Rays in any direction as kernels see them: see ray/ray_frame.h, which proves the margins.
#pragma once

#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// Four affine functions of a place in a tree's own frame, in units of the layout: entry i is
/// shift[i] + ((column[0][i] x + column[1][i] y) + column[2][i] z).
struct alignas(64) LineView {
  std::array<std::array<double, 4>, 3> column = {};
  std::array<double, 4> shift = {};

  /// At the origin of a node or block. Products that underflow are off by 2^-1075, and what a float
  /// is too small for by 2^-150: both are within the slack.
  [[nodiscard]] std::array<float, 4> at(const std::array<double, 3>& origin) const {
    std::array<float, 4> seen = {};
    for (std::size_t i = 0; i < 4; ++i) {
      const double turned =
          (column[0][i] * origin[0] + column[1][i] * origin[1]) + column[2][i] * origin[2];
      seen[i] = static_cast<float>(shift[i] + turned);
    }
    return seen;
  }
};

/// A ray beside a tree. Places along it are counted on the axis of its largest component, from the
/// tree's origin.
struct alignas(64) LineNumbers {
  /// From a node's origin to the place of the ray that is abreast of it, along the mesh's axes, and
  /// that place along the ray.
  LineView node_view;
  /// The ray's direction along the mesh's axes, for a step of one along the ray; no component is
  /// less than kLeastAhead. One over it, and the magnitudes of that.
  std::array<float, 4> ahead = {1, 1, 1, 1};
  std::array<float, 4> inverse = {1, 1, 1, 1};
  std::array<float, 4> reach = {1, 1, 1, 1};
  /// A block's origin along the ray (0), from the tree's origin, and across it (1, 2), from the
  /// ray.
  LineView block_view;
  std::array<std::array<float, 4>, 3> row = {};  ///< rows of P R, padded by zeros
  double scale = 1;                              ///< turns the mesh's units into the layout's
  float node_slack = 0;                          ///< U in units of the layout
  float slack = 0;                               ///< W in units of the layout
  float near_open = 0;                           ///< what ends before this is off the ray
  float near_sure = 0;  ///< what begins after this, and ends before `far_sure`, is not
  float far_sure = 0;
  float far_open = 0;  ///< what begins after this is off the ray, or does not matter
};

/// Components of a direction are not taken for less.
inline constexpr float kLeastAhead = 0x1p-24F;

/// A node, or a block, that is still to be looked at.
struct Ahead {
  float near;           ///< nothing in it is nearer along the ray
  std::uint32_t token;  ///< of WideNode::child

  [[nodiscard]] bool operator==(const Ahead&) const = default;
};

/// A ray on its way through a tree: what is still to be looked at, the next one last.
struct LineDescent {
  const LineNumbers* line;
  Ahead* stack;
  std::size_t size;     ///< entries of the stack
  std::size_t room;     ///< entries that it can hold
  std::size_t steps;    ///< nodes that may still be entered
  std::uint64_t boxes;  ///< boxes tested so far
};

/// Rays that take turns.
inline constexpr std::size_t kMostDescents = 16;

/// A ray against a block. Bounds of places along it: of all corners, and tighter ones where the
/// ray's line surely crosses the triangle.
struct LineBlockTask {
  const LineNumbers* line;
  const TriangleBlock* block;
  std::uint32_t through;  ///< out: triangles that the ray's line surely crosses, off their edges
  std::uint32_t sure;     ///< out: of these, those that the ray surely crosses
  std::uint32_t open;     ///< out: undecided ones; all others the ray surely misses
  std::array<float, 8> near;  ///< out: where the ray meets a triangle, it does so after this
  std::array<float, 8> far;   ///< out: and before this
};

}  // namespace soms::detail
