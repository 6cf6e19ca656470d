/// \file
/// How far the color of a contact reaches.
#pragma once

#include "soms/geometry/parts_of.h"

#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace soms::view {

/// Lengths in parts of the diagonal of the smaller of the two things that touch: of the part of
/// a file that holds the triangle where there are parts, else of the body. A pipe that crosses a
/// wall of a house is marked as a pipe, not as a house.
class GlowReach {
 public:
  /// The scene must stay.
  explicit GlowReach(const ViewScene& scene) : scene_(scene) {}

  /// \cost O(log p) for p parts; O(triangles of the part) where it is new.
  [[nodiscard]] double operator()(const Touch& touch);

 private:
  /// Diagonals of the parts of a mesh; below 0 where it was not needed yet.
  struct Parts {
    PartsOf of;
    std::vector<double> diagonals;
  };

  double diagonal(BodyRef body, TriangleId triangle);

  const ViewScene& scene_;
  std::map<const Mesh*, Parts> parts_;
};

}  // namespace soms::view
