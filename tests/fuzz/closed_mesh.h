/// \file
/// Meshes whose surface is closed, mostly, out of bytes.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/scales.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace soms::fuzz {

/// A number of a lattice, a power of two, or one a step of the last place beside a whole one.
inline double coordinate(Bytes& bytes, double unit) {
  const double on_lattice = static_cast<double>(bytes.below(5)) - 1;
  switch (bytes.below(5)) {
    case 0:
      return unit * std::ldexp(on_lattice, static_cast<int>(bytes.below(80)) - 60);
    case 1:
      return unit * (on_lattice + std::ldexp(static_cast<double>(bytes.below(7)) - 3, -52));
    case 2:
      return unit * 4 * bytes.fraction();
    default:
      return unit * on_lattice;
  }
}

inline Vec3 place(Bytes& bytes, double unit) {
  const double x = coordinate(bytes, unit);
  const double y = coordinate(bytes, unit);
  return {x, y, coordinate(bytes, unit)};
}

/// Faces of tetrahedra, some of them much smaller than others, left out, doubled or without area.
inline Mesh closed_mesh(Bytes& bytes, double unit) {
  Mesh mesh;
  for (std::uint32_t k = 0, count = 1 + bytes.below(10); k < count; ++k) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const double heap = unit_of_heap(bytes, unit);
    for (int corner = 0; corner < 4; ++corner) {
      mesh.vertices.push_back(place(bytes, heap));
    }
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2},
                                                 {first, first + 1, first + 3},
                                                 {first + 3, first + 1, first + 2},
                                                 {first, first + 3, first + 2}});
  }
  const std::uint32_t change = bytes.below(8);
  if (change == 0) {
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(bytes.below(4)));
  } else if (change == 1) {
    mesh.triangles.push_back({0, 1, bytes.below(2)});
    mesh.triangles.push_back(mesh.triangles[0]);
    mesh.triangles.push_back(mesh.triangles[0]);
  }
  return mesh;
}

/// Any rule, leaf size and layout.
inline ShapeOptions shape_options(Bytes& bytes) {
  const auto table = rules();
  ShapeOptions options;
  options.build.rule = table[bytes.below(static_cast<std::uint32_t>(table.size()))].rule;
  options.build.per_leaf = static_cast<int>(1 + bytes.below(16));
  options.layout = bytes.below(3) == 0 ? Layout::compact : Layout::wide;
  return options;
}

}  // namespace soms::fuzz
