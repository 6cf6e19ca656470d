/// \file
/// Rays as exact arithmetic takes them.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/ray.h"

namespace soms::detail {

[[nodiscard]] inline RayLine line_of(const Ray& ray) {
  return ray.end ? RayLine{ray.origin, *ray.end, 1, true}
                 : RayLine{ray.origin, ray.direction, ray.length, false};
}

}  // namespace soms::detail
