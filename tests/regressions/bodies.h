/// \file
/// Bodies of more than one regression test.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include <array>
#include <utility>

namespace soms::test {

/// The box [0, 1]^3.
[[nodiscard]] const Mesh& unit_box();

/// A rod of radius 0.2 about the y axis at height 0.5, from y = 0.1 to 1.9.
[[nodiscard]] Mesh rod_body();

/// A channel open at the top and at both ends, 1 wide inside, in which `rod_body` lies clear.
[[nodiscard]] Mesh channel_body();

/// The closed surface of a cylinder about the z axis, from z = -1 to z = 1, seen from outside.
[[nodiscard]] Mesh cylinder_body(double radius, int sides);

/// A direction of unit length, but for rounding, drawn evenly.
[[nodiscard]] Vec3 even_direction(Rng& rng);

/// A rotation drawn evenly, and a shift shorter than 0.4.
[[nodiscard]] Pose deep_pose(Rng& rng);

/// A cube of side 0.25 at a pose where its foremost corner is in the middle of the face x = 0.25 of
/// the box [0, 0.25]^3, but for rounding. A step of 2^-54 along x is the least.
struct KissingCube {
  Mesh wall;
  Mesh cube;
  Pose pose;
};

[[nodiscard]] KissingCube kissing_cube(Rng& rng);

/// The two triangles of R05.
[[nodiscard]] std::pair<Triangle, Triangle> triangles_of_r05();

/// The triangle with its corners in all six orders.
[[nodiscard]] std::array<Triangle, 6> corner_orders(const Triangle& t);

}  // namespace soms::test
