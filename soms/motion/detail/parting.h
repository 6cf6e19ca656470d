/// \file
/// A direction that parts two triangles, as well as plain doubles find one.
#pragma once

#include "soms/base/vector.h"
#include "soms/motion/detail/motion_interval.h"

#include <array>

namespace soms::detail {

using Corners = std::array<Vec3, 3>;

[[nodiscard]] inline Corners corners_of(const Triangle& t) {
  return {t.a, t.b, t.c};
}

[[nodiscard]] inline Triangle triangle_of(const Corners& c) {
  return {c[0], c[1], c[2]};
}

[[nodiscard]] inline Corners placed(const Corners& c, const Pose& pose) {
  return {pose.apply(c[0]), pose.apply(c[1]), pose.apply(c[2])};
}

/// Directions of a triangle's edges and normal, of length 1; zero where it has none.
struct TriangleSides {
  Vec3 normal;
  std::array<Vec3, 3> edge;
};

[[nodiscard]] TriangleSides sides_of(const Corners& c);

/// A direction of length 1, or zero, and how far x is beyond y along it: below 0 where they overlap
/// in that view.
struct Parting {
  Vec3 direction;
  double gap = 0;
};

/// How far x is beyond y along `n`.
[[nodiscard]] double gap_along(const Vec3& n, const Corners& x, const Corners& y);

/// `n` or its opposite, whichever parts the triangles by more.
[[nodiscard]] Parting parted_along(const Vec3& n, const Corners& x, const Corners& y);

/// The direction of a shortest segment, which normals of faces and products of edges give where
/// they can: differences of near points have few digits. Unless that parts the triangles by more
/// than `enough`, the best of all normals and products.
[[nodiscard]] Parting parting_of(const Corners& x, const Corners& y, double enough);

/// Calls `look(n)` for the directions that decide whether triangles overlap, until it is false:
/// both normals, then the products of the edges. Each is of length 1 or zero.
template <class Look>
void for_separating_directions(const TriangleSides& x, const TriangleSides& y, const Look& look) {
  if (!look(x.normal) || !look(y.normal)) {
    return;
  }
  for (const Vec3& e : x.edge) {
    for (const Vec3& f : y.edge) {
      if (!look(direction_of(cross(e, f)))) {
        return;
      }
    }
  }
}

}  // namespace soms::detail
