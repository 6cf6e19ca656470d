/// \file
/// All triangles that a ray meets, put into the order and the crossings of `all_hits`.
#pragma once

#include "soms/geometry/detail/exact/exact_ray.h"
#include "soms/geometry/detail/ray_plane.h"
#include "soms/query/answer.h"
#include "soms/query/body.h"
#include "soms/query/ray.h"

#include <vector>

namespace soms::detail {

/// A triangle that a ray meets.
struct FoundHit {
  TimeBounds bounds;  ///< in units of the scaled direction
  TriangleId id = 0;
  bool inside = false;  ///< the ray's line crosses it off its edges
};

/// A place where a ray meets the surface; its triangles follow each other in a list.
struct FoundCrossing {
  Bracket t;
  CrossingKind kind = CrossingKind::graze;
  std::size_t triangles = 0;
};

/// What one ray found.
struct RayRow {
  std::vector<FoundCrossing> crossings;
  std::vector<TriangleId> triangles;
};

/// Sorts what a ray found by exact time and forms crossings. Triangles whose bounds part them from
/// all others need no whole numbers.
void form_crossings(const Body& body, const RayLine& line, const ScaledDirection& direction,
                    std::vector<FoundHit>& found, RayRow& row, Cost& cost);

}  // namespace soms::detail
