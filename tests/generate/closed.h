/// \file
/// What tests of generated bodies count.
#pragma once

#include "soms/geometry/mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace soms::test {

/// Directed edges, by vertex position, that lack their opposite or occur twice: none in a closed,
/// consistently turned surface.
inline std::size_t faulty_edges(const Mesh& mesh) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> uses;
  const auto point = [&](std::uint32_t v) {
    const Vec3& p = mesh.vertices[v];
    return Point{p.x, p.y, p.z};
  };
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{point(t[i]), point(t[(i + 1) % 3])}];
    }
  }
  std::size_t faulty = 0;
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    faulty += count != 1 || opposite == uses.end() || opposite->second != 1 ? 1U : 0U;
  }
  return faulty;
}

/// Six times the volume inside a closed surface; positive when its faces look outward.
inline double volume6(const Mesh& mesh) {
  double sum = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    sum += dot(t.a, cross(t.b, t.c));
  }
  return sum;
}

inline double area(const Triangle& t) {
  const Vec3 normal = cross(t.b - t.a, t.c - t.a);
  return 0.5 * std::sqrt(dot(normal, normal));
}

/// Triangles that are without area, or so thin that their area is rounding.
inline std::size_t flat_triangles(const Mesh& mesh) {
  std::size_t flat = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const Vec3 u = t.b - t.a;
    const Vec3 v = t.c - t.a;
    flat += area(t) <= 1e-9 * (dot(u, u) + dot(v, v)) ? 1U : 0U;
  }
  return flat;
}

/// The triangles of one part as a mesh of their own.
inline Mesh part_mesh(const Mesh& mesh, const Part& part) {
  Mesh one;
  one.vertices = mesh.vertices;
  one.triangles.assign(mesh.triangles.begin() + part.first,
                       mesh.triangles.begin() + part.first + part.count);
  return one;
}

}  // namespace soms::test
