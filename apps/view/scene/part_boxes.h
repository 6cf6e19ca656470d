/// \file
/// Bounds of the parts of a scene's bodies.
#pragma once

#include "soms/geometry/parts_of.h"

#include "apps/view/scene/view_scene.h"

#include <map>
#include <vector>

namespace soms::view {

/// What stands for a triangle where something touches it: the part of the file that holds it, or
/// its body where no part does. Of a pipe that crosses a wall of a house it is the pipe, not all
/// pipes, and the wall, not the house.
class PartBoxes {
 public:
  /// The scene must stay, with its bodies where they are.
  explicit PartBoxes(const ViewScene& scene) : scene_(scene) {}

  /// Bounds, in the coordinates of the scene.
  /// \cost O(log p) for p parts; O(triangles of the part) where it is new.
  [[nodiscard]] Box operator()(BodyRef body, TriangleId triangle);

 private:
  /// Bounds of the parts of a mesh in its own coordinates; empty where they were not needed yet.
  struct Parts {
    PartsOf of;
    std::vector<Box> boxes;
  };

  const ViewScene& scene_;
  std::map<const MeshView*, Parts> parts_;
};

}  // namespace soms::view
