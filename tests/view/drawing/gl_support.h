/// \file
/// For tests that draw: OpenGL without a screen, and simple meshes.
#pragma once

#include "soms/base/error.h"

#include "apps/view/drawing/gl/gl_renderer.h"
#include "apps/view/drawing/gl/headless_context.h"
#include "tests/support/support.h"

#include <memory>
#include <optional>
#include <string>

namespace soms::view::test_drawing {

/// A context and a renderer, or why there are none.
struct Drawing {
  std::optional<HeadlessContext> context;
  std::optional<GlRenderer> renderer;
  std::string missing;

  Drawing() {
    try {
      context.emplace();
      renderer.emplace();
    } catch (const Error& error) {
      missing = error.what();
    }
  }
};

/// A rectangle square to axis y at `y`, seen from -y.
inline Mesh wall(double y, double x0, double z0, double x1, double z1) {
  Mesh mesh;
  mesh.vertices = {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A closed box of 12 triangles, appended.
inline void add_block(Mesh& mesh, const Vec3& lower, const Vec3& upper) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                             (i & 4) != 0 ? upper.z : lower.z});
  }
  constexpr std::uint32_t kFaces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                           {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                           {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
  }
}

/// Blocks on a grid of `n` by `n`, 20 apart, from 4 to 40 high, all at multiples of 1/4, about
/// `center`.
inline Mesh blocks(int n, const Vec3& center = {}) {
  Rng rng(7);
  Mesh mesh;
  const int first = -(n / 2);
  for (int i = first; i < first + n; ++i) {
    for (int k = first; k < first + n; ++k) {
      const Vec3 at = center + Vec3{20.0 * i, 20.0 * k, 0};
      const double high = 4 + 0.25 * static_cast<double>(rng.below(145));
      add_block(mesh, at, at + Vec3{12, 12, high});
    }
  }
  return mesh;
}

inline DrawList list_of(Mesh mesh, Color color = {190, 190, 190, 255}) {
  DrawList list;
  list.meshes.push_back({.key = 1, .mesh = std::make_shared<const Mesh>(std::move(mesh))});
  list.instances.push_back({.mesh = 0, .color = color});
  return list;
}

/// From -y, ten units before the origin.
inline Camera before_origin() {
  return {{0, -10, 0}, {0, 0, 0}, {0, 0, 1}, 0.8};
}

}  // namespace soms::view::test_drawing

/// Gives `drawing`, or skips the test aloud where nothing can be drawn here.
#define SOMS_NEEDS_GL(drawing)                                                           \
  ::soms::view::test_drawing::Drawing drawing;                                           \
  if (!(drawing).renderer) {                                                             \
    GTEST_SKIP() << "nothing is drawn here, so this is untested: " << (drawing).missing; \
  }                                                                                      \
  static_assert(true)
