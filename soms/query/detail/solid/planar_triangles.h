/// \file
/// Quick answers, none of them wrong, about triangles that may lie in one plane or cut each other.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/predicates.h"

namespace soms::detail {

[[nodiscard]] bool has_area(const Triangle& t, Predicates& predicates);

/// False only if no segment of `s` parts the interior of `t`, and `s` covers nothing of it: of s,
/// nothing is in the plane of t but a point, or an edge of t, or what has no area in common with t.
/// \pre `t` has area.
[[nodiscard]] bool may_cut(const Triangle& t, const Triangle& s, Predicates& predicates);

/// False only if the triangles have no area in common. \pre `t` has area.
[[nodiscard]] bool may_share_area(const Triangle& t, const Triangle& s, Predicates& predicates);

}  // namespace soms::detail
