/// \file
/// Overlap of triangles that are not in general position: in one plane, or without area.
#pragma once

#include "soms/base/vector.h"
#include "soms/geometry/detail/exact/predicates.h"

namespace soms::detail {

/// True if two closed triangles share a point, each taken as the triangle, segment or point it is.
/// \pre  Both have area only if they are coplanar.
[[nodiscard]] bool flat_overlap(const Triangle& s, const Triangle& t, Predicates& predicates);

}  // namespace soms::detail
