/// \file
/// Rays and segments as exact arithmetic takes them.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/query/ray.h"

namespace soms::detail {

[[nodiscard]] inline RayLine line_of(const Ray& ray) {
  return {ray.origin, ray.direction, ray.length, false};
}

[[nodiscard]] inline RayLine line_of(const Segment& segment) {
  return {segment.from, segment.to, 1, true};
}

}  // namespace soms::detail
