/// \file
/// How near are two triangles? Decided exactly.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"

namespace soms {

/// The least distance of two triangles, and where it is.
struct TriangleDistance {
  /// The doubles next to the distance; [0, 0] exactly where `triangles_overlap`.
  Bracket distance;
  Vec3 point_a;  ///< the end of a shortest segment on the first triangle
  Vec3 point_b;  ///< on the second

  [[nodiscard]] bool operator==(const TriangleDistance&) const = default;
};

/// The least distance of two closed triangles. A triangle without area is the segment or point it
/// is.
///
/// The points are within 4 units in the last place of the largest coordinate of the six corners of
/// the ends of a shortest segment. Where there are many, as between parallel edges or faces, they
/// are the middle ones: the points of `a` that are nearest to `b` are a convex polygon or segment,
/// `point_a` is the mean of its corners, and `point_b` what is nearest to it. Where the triangles
/// overlap, both are the mean of the corners of what they have in common. But for rounding this
/// does not depend on the order of corners, nor on that of the triangles.
///
/// \pre     Coordinates are finite and of magnitude at most 2^300.
/// \errors  None but memory.
/// \cost    About 2 us; where features tie, as between parallel faces, 10 us and more.
[[nodiscard]] TriangleDistance triangle_distance(const Triangle& a, const Triangle& b);

/// Whether the least distance of two closed triangles is at most `distance`: decided exactly.
/// \pre     As for `triangle_distance`; `distance` is not negative.
/// \errors  None but memory.
/// \cost    About 400 ns, unless `distance` is next to the distance itself.
[[nodiscard]] bool triangles_within(const Triangle& a, const Triangle& b, double distance);

}  // namespace soms
