/// \file
/// A cube that tests of files write in many ways.
#pragma once

#include "soms/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::test {

/// Corners of the cube's sides, seen from outside.
inline constexpr std::array<std::array<int, 4>, 6> kSides = {
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

/// Corner k of the cube [0, 1]^3 has x, y, z as bits 0, 1, 2 of k.
inline Vec3 cube_corner(int k) {
  return {static_cast<double>(k & 1), static_cast<double>(k >> 1 & 1),
          static_cast<double>(k >> 2 & 1)};
}

/// The cube as readers give it: sides as fans, seen from outside.
inline Mesh cube() {
  Mesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.push_back(cube_corner(k));
  }
  for (const auto& side : kSides) {
    const auto v = [&side](std::size_t i) { return static_cast<std::uint32_t>(side[i]); };
    mesh.triangles.push_back({v(0), v(1), v(2)});
    mesh.triangles.push_back({v(0), v(2), v(3)});
  }
  return mesh;
}

}  // namespace soms::test
