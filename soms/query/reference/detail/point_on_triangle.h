/// \file
/// Is a point a point of a triangle? As two triangles overlap.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"
#include "soms/geometry/triangle_overlap.h"

namespace soms::reference::detail {

/// The point, taken as a triangle, overlaps the closed one: exactly.
[[nodiscard]] inline bool is_on(const Triangle& t, const Vec3& p) {
  return overlaps(bounds(t), Box{p, p}) && triangles_overlap(t, {p, p, p});
}

}  // namespace soms::reference::detail
