/// \file
/// What two triangles have in common, or would have if one were moved along the shortest segment to
/// the other: a convex polygon, segment or point, by its corners in whole numbers.
#pragma once

#include "soms/geometry/detail/exact/exact_distance.h"
#include "soms/geometry/detail/exact/integer.h"
#include "soms/geometry/detail/feature_pair.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace soms::detail {

/// The point corner[begin] + part / whole (corner[end] - corner[begin]) of a triangle; none where
/// `whole` is 0.
struct Share {
  std::size_t begin = 0;
  std::size_t end = 0;
  Integer part;
  Integer whole;
};

/// One corner, as a point of either triangle or of both; as one only where the other is at the same
/// place or across the gap.
struct CommonCorner {
  Share on_a;
  Share on_b;
};

/// A direction at right angles to both features, which a shortest segment joins: from the first
/// triangle to the second or back.
[[nodiscard]] IntegerVec direction(const ExactPair& pair, const FeaturePair& features);

/// The corners, each once. With a direction `n`: of the parts of both triangles that are farthest
/// along it on the sides that face each other, seen along `n`; without: of the points of both.
[[nodiscard]] std::vector<CommonCorner> common_corners(const ExactPair& pair,
                                                       const FeaturePair& features,
                                                       const std::optional<IntegerVec>& n);

}  // namespace soms::detail
