/// \file
/// Rays along a world axis as kernels see them: see parity_frame.h, which proves the margins.
#pragma once

#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstdint>

namespace soms::detail {

/// What the rays into one body share: R, the axes and the margin of parity_frame.h. Index 0 is the
/// axis of the rays, 1 and 2 are those across it.
struct alignas(64) RayNumbers {
  std::array<std::array<float, 4>, 3> row = {};     ///< rows of R, padded by zeros
  std::array<std::array<double, 3>, 3> exact = {};  ///< the same in double
  std::array<std::uint8_t, 3> axis = {};            ///< 0 is x
  bool rotated = false;                             ///< false: R is the identity, to the bit
  float slack = 0;                                  ///< W in units of the layout
  double scale = 1;                                 ///< turns the mesh's units into the layout's
};

/// A ray: from a point, toward greater coordinates (1) or lesser ones (-1).
struct RayStart {
  std::array<double, 3> from = {};  ///< from the point to the tree's origin: D of parity_frame.h
  float sign = 1;
};

/// A ray against a node.
struct RayNodeTask {
  const RayNumbers* numbers;
  const RayStart* start;
  const WideNode* node;
  std::uint32_t lanes;  ///< out: those that the ray may meet
};

/// A ray against a block.
struct RayBlockTask {
  const RayNumbers* numbers;
  const RayStart* start;
  const TriangleBlock* block;
  std::uint32_t cross;  ///< out: triangles that the ray surely crosses, off their edges
  std::uint32_t open;   ///< out: undecided ones; all others it surely misses
};

}  // namespace soms::detail
