/// \file
/// Boxes, cylinders and spheres of robots as closed meshes.
#pragma once

#include "soms/geometry/mesh.h"

namespace soms {

/// A closed mesh in the place of a shape that may be round, and how far it is from that. A size of
/// 0 makes it flat, a segment or a point: closed all the same, and nothing is inside of it.
struct PrimitiveMesh {
  Mesh mesh;
  /// The mesh holds the shape, and no point of it is farther than this from the shape. But for the
  /// rounding of its vertices, some 1e-16 of the size.
  double error = 0;

  [[nodiscard]] bool operator==(const PrimitiveMesh&) const = default;
};

/// The box of these side lengths about the origin: 12 triangles.
/// \errors ErrorKind::usage unless each is finite, at least 0 and at most 2^299.
[[nodiscard]] PrimitiveMesh box_mesh(const Vec3& size);

/// A prism that holds the cylinder about the z axis, from -length / 2 to length / 2: its sides
/// touch the cylinder. It has the fewest sides that keep `error` at most `most_error`, at least 8.
/// \errors ErrorKind::usage unless radius and length are finite, at least 0 and at most 2^299, and
///         `most_error` is finite and positive; out_of_range where it would have more than 4,096
///         sides.
[[nodiscard]] PrimitiveMesh cylinder_mesh(double radius, double length, double most_error);

/// A polyhedron that holds the sphere about the origin: slices of a circle of at least 8 points,
/// twice as many as rings. \errors As `cylinder_mesh`; out_of_range above 1,024 points.
[[nodiscard]] PrimitiveMesh sphere_mesh(double radius, double most_error);

}  // namespace soms
