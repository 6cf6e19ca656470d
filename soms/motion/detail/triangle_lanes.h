/// \file
/// The triangles of a block side by side, over a stretch of the way.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/motion/detail/time_window.h"
#include "soms/tree/layout/detail/wide_tree.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::detail {

/// The triangles of a block over a stretch of the way, in the frame of the law. All corners of one
/// move as their mean does, but for `give`. Lanes from `count` on repeat the last one.
struct alignas(64) TriangleLanes {
  static constexpr std::size_t kLanes = TriangleBlock::kWidth;

  using Row = std::array<double, kLanes>;
  using Vectors = std::array<Row, 3>;  ///< axis, lane

  std::size_t count = 0;
  std::array<Vectors, 3> corner;  ///< in the middle of the stretch
  std::array<Vectors, 3> edge;    ///< from corner k to the next, of length 1 or zero
  Vectors normal;                 ///< likewise
  Vectors change;                 ///< from the middle of the stretch to its end
  Row give;
  std::array<TriangleId, kLanes> id;
};

/// Windows of lanes: bit k of `open` is set where that of lane k is not empty. Those of others may
/// be anything.
struct alignas(64) WindowsOfLanes {
  TriangleLanes::Row lower;
  TriangleLanes::Row upper;
  std::uint32_t open = 0;

  [[nodiscard]] TimeWindow at(std::size_t lane) const { return {lower[lane], upper[lane]}; }
};

/// The triangles of a block, in the coordinates of their body: the kernels of motion_kernels.h fill
/// in the rest.
void gather_lanes(const MeshView& mesh, const TriangleBlock& block, TriangleLanes& lanes);

/// Leaves those whose bits are set. \pre One is.
void keep_lanes(std::uint32_t bits, TriangleLanes& lanes);

}  // namespace soms::detail
