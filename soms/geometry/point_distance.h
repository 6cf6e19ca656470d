/// \file
/// How near is a point to a triangle, and where? Decided exactly.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/base/words.h"

#include <cstdint>

namespace soms {

/// Where on a triangle a point lies.
enum class TriangleFeature : std::uint8_t {
  vertex,  ///< it is a corner
  edge,    ///< it is on an edge, and no corner
  face,    ///< it is inside
};

template <>
inline constexpr auto kWords<TriangleFeature> = words("TriangleFeature",
                                                      "Where on a triangle a point lies.", "vertex",
                                                      "edge", "face");

/// The least distance of a point from a triangle, and where it is.
struct PointDistance {
  /// The doubles next to the distance; [0, 0] exactly where the point is on the triangle.
  Bracket distance;
  Vec3 point;                                         ///< the nearest point of the triangle
  TriangleFeature feature = TriangleFeature::vertex;  ///< where that lies

  [[nodiscard]] bool operator==(const PointDistance&) const = default;
};

/// The least distance of a point from a closed triangle. A triangle without area is the segment or
/// point it is; its corners are vertices, the rest of it is edge.
///
/// Each coordinate of the nearest point is the exact one rounded to the nearest double, ties to
/// even. `feature` is that of the exact point.
///
/// \pre     Coordinates are finite and of magnitude at most 2^300.
/// \errors  None but memory.
/// \cost    About 300 ns; some 3 us where the nearest point is next to a border of features.
[[nodiscard]] PointDistance point_distance(const Vec3& point, const Triangle& triangle);

}  // namespace soms
