/// \file
/// Triangles of a body where its pose has moved them, and their boxes: what brute force scans.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/vector.h"
#include "soms/geometry/mesh.h"

#include <array>
#include <vector>

namespace soms::reference::detail {

/// The triangles with moved, rounded corners.
/// \errors As for a query of the mesh at the pose.
[[nodiscard]] std::vector<Triangle> moved_triangles(const MeshView& mesh, const Pose& pose);

/// Boxes as one array for each side, which compilers turn into vector code.
struct BoxArrays {
  std::array<std::vector<double>, 3> lower;
  std::array<std::vector<double>, 3> upper;

  explicit BoxArrays(const std::vector<Triangle>& triangles);
};

}  // namespace soms::reference::detail
