/// \file
/// What two triangles have in common: a point, a segment or an outline, for drawing.
#pragma once

#include "soms/base/vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace soms {

/// What two triangles have in common, by its corners.
struct CommonPoints {
  std::array<Vec3, 6> corners;
  std::size_t count = 0;  ///< 0 nothing, 1 a point, 2 a segment, 3 to 6 the outline of an area

  /// The corners; of an area in order around it, either way.
  [[nodiscard]] std::span<const Vec3> points() const { return {corners.data(), count}; }

  [[nodiscard]] bool empty() const { return count == 0; }

  /// The same corners, in the same order.
  [[nodiscard]] bool operator==(const CommonPoints& other) const {
    return std::equal(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count),
                      other.corners.begin(),
                      other.corners.begin() + static_cast<std::ptrdiff_t>(other.count));
  }
};

/// The common points of two closed triangles. Whether there are any is exact, as
/// `triangles_overlap` says; where they are is for drawing.
///
/// Each corner is within 1e-12 of the extent (the longest side of the box around both triangles) of
/// a corner of the true common set, plus two roundings of its own coordinates. Corners nearer to
/// each other than that are one, so a tiny segment may be given as a point and a sliver of an area
/// as a segment. A triangle without area is the segment or point it is.
///
/// \pre     Coordinates are finite and of magnitude at most 2^300.
/// \errors  None but memory.
/// \cost    About 1 us in general position, 5 us where coordinates are of very unlike size; 20 us
///          where corners or edges touch.
[[nodiscard]] CommonPoints common_points(const Triangle& s, const Triangle& t);

}  // namespace soms
