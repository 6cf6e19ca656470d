/// \file
/// Representative points of triangles, by which splitting rules sort them.
#pragma once

#include "soms/base/vector.h"
#include "soms/base/words.h"

namespace soms {

/// Which point stands for a triangle.
enum class Midpoint {
  thesis,    ///< 0.5*(0.5*(A+B)+C), fig. 4.23 of the thesis; depends on which corner is C
  centroid,  ///< ((A+B)+C)/3
  aabb,      ///< middle of the triangle's box
};

template <>
inline constexpr auto kWords<Midpoint> = words("Midpoint",
                                               "Which point of a triangle is its middle.", "thesis",
                                               "centroid", "aabb");

/// Midpoint of a triangle, one rounding an operation. `c_vertex` (0, 1, 2) says which corner is C;
/// the other two follow in cyclic order: 2 gives (a, b, c), 0 gives (b, c, a), 1 gives (c, a, b).
/// \source  thesis, fig. 4.23.
[[nodiscard]] Vec3 midpoint(const Triangle& t, Midpoint kind, int c_vertex = 2);

}  // namespace soms
