/// \file
/// Small robots that tests build by hand.
#pragma once

#include "soms/kinematics/robot.h"

#include "tests/support/bodies.h"

#include <string>
#include <utility>

namespace soms::test {

/// A robot of boxes that slide along x, each by a joint of its own from the root, which has no
/// mesh: link k + 1 is boxes[k]. Names are "root", "a", "b", ...
[[nodiscard]] inline Robot sliding_robot(std::vector<Mesh> boxes) {
  Robot robot{.name = "sliding", .links = {{.name = "root"}}};
  for (std::uint32_t k = 0; k < boxes.size(); ++k) {
    const std::string name(1, static_cast<char>('a' + k));
    robot.links.push_back({.name = name, .collisions = {std::move(boxes[k])}});
    robot.joints.push_back({.name = "x_" + name,
                            .type = JointType::prismatic,
                            .parent = 0,
                            .child = k + 1,
                            .lower = -100,
                            .upper = 100});
  }
  return robot;
}

/// The box [-half, half]^3.
[[nodiscard]] inline Mesh cube(double half) {
  return box_body({-half, -half, -half}, {half, half, half});
}

/// The same without its first triangle: an open body.
[[nodiscard]] inline Mesh open_cube(double half) {
  Mesh mesh = cube(half);
  mesh.triangles.erase(mesh.triangles.begin());
  return mesh;
}

}  // namespace soms::test
