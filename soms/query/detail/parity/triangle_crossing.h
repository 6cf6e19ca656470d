/// \file
/// Does a ray along an axis cross a triangle? Decided exactly, so that crossings can be counted.
#pragma once

#include "soms/base/vector.h"

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

}  // namespace soms::detail
