/// \file
/// Does a ray along an axis cross a triangle? Decided exactly, so that crossings can be counted.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/predicates.h"

#include <cstddef>

namespace soms::detail {

/// How a ray meets a triangle.
enum class RayHit {
  miss,
  cross,
  on,  ///< the ray's start is a point of the triangle
};

/// The ray from `p` along `axis` (0 is x), toward greater coordinates if `forward`.
///
/// A ray through an edge or a corner is taken as one beside it: from (p1 + e, p2 + e^2) across the
/// axis, for a positive e that is less than anything here. So of the triangles around an edge or a
/// corner, it crosses those that a ray nearby would cross, and parity is right. A triangle that is
/// parallel to the ray, or has no area, is never crossed; `on` holds for it as for any other.
/// Sets `exact` where a filter left something open.
/// \source Edelsbrunner and Muecke 1990, Simulation of Simplicity, section 4.
[[nodiscard]] RayHit triangle_crossing(const Triangle& t, const Vec3& p, std::size_t axis,
                                       bool forward, bool& exact);

/// On which side of an edge, seen along `axis`, the ray from `p` passes, moved as above: `positive`
/// where the edge's ends and it turn counter-clockwise in the plane across; `zero` only if the edge
/// is parallel to the axis.
[[nodiscard]] Sign side_of_ray(const Vec3& from, const Vec3& to, const Vec3& p, std::size_t axis,
                               Predicates& predicates);

/// Whether a ray along `axis` that crosses a triangle passes from its back to its front, that from
/// which it is seen counter-clockwise. \pre It crosses the triangle.
[[nodiscard]] bool crosses_to_front(const Triangle& t, std::size_t axis, bool forward);

}  // namespace soms::detail
