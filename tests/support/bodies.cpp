#include "tests/support/bodies.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace soms::test {

namespace {

/// Adds the face at the lower or upper side of `axis`.
void add_face(Mesh& mesh, const Box& box, std::size_t axis, bool above, int cuts) {
  const std::size_t u = (axis + 1) % 3;
  const std::size_t v = (axis + 2) % 3;
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const auto place = [&](std::size_t k, int i) {
    return i == cuts ? box.upper[k] : box.lower[k] + box.extent()[k] * i / cuts;
  };
  for (int i = 0; i <= cuts; ++i) {
    for (int j = 0; j <= cuts; ++j) {
      Vec3 p;
      p[axis] = above ? box.upper[axis] : box.lower[axis];
      p[u] = place(u, i);
      p[v] = place(v, j);
      mesh.vertices.push_back(p);
    }
  }
  const auto row = static_cast<std::uint32_t>(cuts) + 1;
  for (std::uint32_t i = 0; i + 1 < row; ++i) {
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
      const std::uint32_t a = first + row * i + j;
      const std::uint32_t b = a + row;
      const std::uint32_t c = b + 1;
      const std::uint32_t d = a + 1;
      mesh.triangles.push_back(above ? std::array{a, b, c} : std::array{a, c, b});
      mesh.triangles.push_back(above ? std::array{a, c, d} : std::array{a, d, c});
    }
  }
}

}  // namespace

Mesh box_body(const Vec3& lower, const Vec3& upper, int cuts) {
  Mesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add_face(mesh, {lower, upper}, axis, false, cuts);
    add_face(mesh, {lower, upper}, axis, true, cuts);
  }
  return mesh;
}

Mesh soup_body(const std::vector<Triangle>& triangles) {
  Mesh mesh;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Mesh joined(Mesh a, const Mesh& b) {
  append(a, b);
  return a;
}

std::vector<Pose> cube_rotations() {
  std::vector<Pose> rotations;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Pose pose;
      pose.m.fill(0);
      for (std::size_t row = 0; row < 3; ++row) {
        pose.m[4 * row + order[row]] = (signs >> row & 1U) != 0 ? -1 : 1;
      }
      const Vec3 x = pose.apply({1, 0, 0});
      const Vec3 y = pose.apply({0, 1, 0});
      const Vec3 z = pose.apply({0, 0, 1});
      if (dot(cross(x, y), z) > 0) {
        rotations.push_back(pose);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

}  // namespace soms::test
