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

/// Makes coarse copies of some triangles of a mesh that lie in a box. First come pieces that reach
/// far in it, such as the ground, made coarser: the box is cut in cubes, and all corners in a cube
/// become the outermost of them. Then come connected pieces that are small in the box, such as
/// houses, as boxes without a floor, the largest first. Where that would be too many, neighbors
/// share a box: of their mean height, and as wide as they are together. So nothing is left out. The
/// first triangle of the largest piece in the order given lends a box its color.
/// \cost    O(n log n) for n triangles, some times.
/// \source  Rossignac, Borrel 1993, Multi-resolution 3D approximations for rendering complex
///          scenes.
class StandInMaker {
 public:
  /// \pre The mesh outlives the object.
  StandInMaker(const Mesh& mesh, std::span<const TriangleId> triangles, const Box& box);

  /// \shape At most `most` triangles, unless two cubes on a side, or one box, give more.
  [[nodiscard]] std::vector<StandInTriangle> at_most(std::size_t most) const;

  /// Triangles that hang together by their corners.
  struct Piece {
    std::vector<TriangleId> triangles;
    Box box;
  };

 private:
  const Mesh& mesh_;
  Box box_;
  std::vector<Piece> small_;  ///< the largest first
  std::vector<TriangleId> far_reaching_;
};

/// A box without a floor in the color of a triangle.
[[nodiscard]] std::vector<StandInTriangle> one_box(TriangleId of, const Box& box);

}  // namespace soms::view
