/// \file
/// Quick answers, none of them wrong, about triangles that may lie in one plane or cut each other.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/predicates.h"

#include <cstddef>

namespace soms::detail {

[[nodiscard]] bool has_area(const Triangle& t, Predicates& predicates);

/// What a triangle `s` may cut of another one, `t`.
enum class CutKind : unsigned char {
  none,     ///< nothing: of s, nothing is in the plane of t but a point, an edge of t, or what has
            ///< no area in common with t
  across,   ///< a segment in which it crosses the plane
  above,    ///< an edge in the plane; the rest of s is where `orientation` is positive
  below,    ///< an edge in the plane; the rest of s is where `orientation` is negative
  coplanar  ///< its edges; both lie in one plane
};

struct TriangleCut {
  CutKind kind = CutKind::none;
  std::size_t edge = 0;  ///< with `above` and `below`: from this corner of s to the next one
};

/// `none` may be missed. \pre `t` has area.
[[nodiscard]] TriangleCut cut_of(const Triangle& t, const Triangle& s, Predicates& predicates);

/// False only if the triangles have no area in common. \pre `t` has area.
[[nodiscard]] bool may_share_area(const Triangle& t, const Triangle& s, Predicates& predicates);

}  // namespace soms::detail
