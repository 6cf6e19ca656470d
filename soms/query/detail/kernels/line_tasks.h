/// \file
/// Rays in any direction as kernels see them: see ray/ray_frame.h, which proves the margins.
#pragma once

#include "soms/tree/layout/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms::detail {

/// A ray beside a tree. Index 0 is along the ray: the axis of its largest component, measured from
/// the tree's origin. 1 and 2 are across it, measured from the ray.
struct alignas(64) LineNumbers {
  std::array<std::array<float, 4>, 3> row = {};     ///< rows of P R, padded by zeros
  std::array<std::array<double, 3>, 3> exact = {};  ///< the same in double
  std::array<double, 3> from = {};  ///< from the ray to the tree's origin, in the mesh's units
  double scale = 1;                 ///< turns these into the layout's
  float slack = 0;                  ///< W in units of the layout
  float near_open = 0;              ///< what ends before this is off the ray
  float near_sure = 0;              ///< what begins after this, and ends before `far_sure`, is not
  float far_sure = 0;
  float far_open = 0;  ///< what begins after this is off the ray, or does not matter
};

/// A ray against a node.
struct LineNodeTask {
  const LineNumbers* line;
  const WideNode* node;
  std::uint32_t lanes;        ///< out: those that the ray may meet
  std::array<float, 4> near;  ///< out: nothing in a lane is nearer along the ray
};

/// A ray against a block.
struct LineBlockTask {
  const LineNumbers* line;
  const TriangleBlock* block;
  std::uint32_t through;  ///< out: triangles that the ray's line surely crosses, off their edges
  std::uint32_t sure;     ///< out: of these, those that the ray surely crosses
  std::uint32_t open;     ///< out: undecided ones; all others the ray surely misses
  std::array<float, 8> near;  ///< out: as for nodes
};

}  // namespace soms::detail
