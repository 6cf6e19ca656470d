#include "apps/view/scene/glow_reach.h"

#include "soms/base/box.h"

#include <algorithm>
#include <cmath>

namespace soms::view {

namespace {

/// Of the diagonal.
constexpr double kGlowReach = 0.09;

double diagonal_of(const Box& box) {
  const Vec3 extent = box.extent();
  return box.empty() ? 0 : std::sqrt(dot(extent, extent));
}

double diagonal_of(const Mesh& mesh, const Part& part) {
  Box box;
  for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      box.grow(mesh.vertices[corner]);
    }
  }
  return diagonal_of(box);
}

}  // namespace

double GlowReach::operator()(const Touch& touch) {
  return kGlowReach * std::min(diagonal(touch.a, touch.i), diagonal(touch.b, touch.j));
}

double GlowReach::diagonal(BodyRef body, TriangleId triangle) {
  const Mesh& mesh = scene_.body(body).shape.mesh();
  const auto [entry, added] = parts_.try_emplace(&mesh);
  Parts& parts = entry->second;
  if (added) {
    parts.of = PartsOf(mesh);
    parts.diagonals.assign(mesh.parts.size(), -1);
  }
  const std::uint32_t part = parts.of(triangle);
  if (part == Part::kNoParent) {
    return diagonal_of(scene_.bounds(body));
  }
  double& length = parts.diagonals[part];
  if (length < 0) {
    length = diagonal_of(mesh, mesh.parts[part]);
  }
  return length;
}

}  // namespace soms::view
