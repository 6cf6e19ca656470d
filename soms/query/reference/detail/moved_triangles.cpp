#include "soms/query/reference/detail/moved_triangles.h"

#include <algorithm>
#include <cstddef>

namespace soms::reference::detail {

std::vector<Triangle> moved_triangles(const MeshView& mesh, const Pose& pose) {
  check(mesh);
  check(pose);
  check_range(pose, bounds(mesh));
  std::vector<Vec3> vertices;
  vertices.reserve(mesh.vertices.size());
  for (const Vec3& v : mesh.vertices) {
    vertices.push_back(pose.apply(v));
  }
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
  }
  return triangles;
}

BoxArrays::BoxArrays(const std::vector<Triangle>& triangles) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lower[axis].reserve(triangles.size());
    upper[axis].reserve(triangles.size());
    for (const Triangle& t : triangles) {
      lower[axis].push_back(std::min({t.a[axis], t.b[axis], t.c[axis]}));
      upper[axis].push_back(std::max({t.a[axis], t.b[axis], t.c[axis]}));
    }
  }
}

}  // namespace soms::reference::detail
