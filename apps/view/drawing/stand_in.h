/// \file
/// Few triangles in place of many, for pictures that move on slow devices.
#pragma once

#include "soms/base/box.h"
#include "soms/geometry/mesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::view {

/// A triangle of a stand-in.
struct StandInTriangle {
  Triangle corners = {};
  TriangleId of = 0;  ///< whose color it has

  [[nodiscard]] bool operator==(const StandInTriangle&) const = default;
};

/// A coarse copy of some triangles of a mesh that lie in a box. First come pieces that reach far in
/// it, such as the ground, made coarser: the box is cut in cubes, and all corners in a cube become
/// the outermost of them. Then come connected pieces that are small in the box, such as houses, as
/// boxes without a floor, the largest first; the smallest are left out. So a first part of a
/// stand-in is one, too. The first triangle of a piece in the order given lends it its color.
/// \shape   At most `most` triangles, unless two cubes on a side give more.
/// \cost    O(n log n) for n triangles, some times.
/// \source  Rossignac, Borrel 1993, Multi-resolution 3D approximations for rendering complex
///          scenes.
[[nodiscard]] std::vector<StandInTriangle> stand_in(const Mesh& mesh,
                                                    std::span<const TriangleId> triangles,
                                                    const Box& box, std::size_t most);

}  // namespace soms::view
