/// \file
/// Small bodies that tests build by hand.
#pragma once

#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"

#include <vector>

namespace soms::test {

/// The closed surface of a box, each face cut into `cuts` x `cuts` squares of two triangles,
/// counter-clockwise seen from outside.
[[nodiscard]] Mesh box_body(const Vec3& lower, const Vec3& upper, int cuts = 1);

/// A mesh of triangles that share no vertices.
[[nodiscard]] Mesh soup_body(const std::vector<Triangle>& triangles);

/// Both meshes as one, triangles of `a` first.
[[nodiscard]] Mesh joined(Mesh a, const Mesh& b);

/// The 24 rotations of the cube: signed permutations of determinant 1.
[[nodiscard]] std::vector<Pose> cube_rotations();

/// The mesh with every vertex replaced by `f(vertex)`.
template <class Function>
[[nodiscard]] Mesh mapped(Mesh mesh, const Function& f) {
  for (Vec3& v : mesh.vertices) {
    v = f(v);
  }
  return mesh;
}

}  // namespace soms::test
