/// \file
/// Triangles with corners in common: do they share more than these? Decided exactly.
#pragma once

#include "soms/base/vector.h"

namespace soms::detail {

/// Whether the triangles (v, p, q) and (v, r, s) share a point other than v. Without area they are
/// the segments or points that they are.
/// \pre Coordinates are finite and of magnitude at most 2^300; the caller holds a PlainArithmetic.
[[nodiscard]] bool share_beyond_corner(const Vec3& v, const Vec3& p, const Vec3& q, const Vec3& r,
                                       const Vec3& s);

/// Whether the triangles (u, v, p) and (u, v, r) share a point outside the segment from u to v.
/// \pre As for `share_beyond_corner`.
[[nodiscard]] bool share_beyond_edge(const Vec3& u, const Vec3& v, const Vec3& p, const Vec3& r);

}  // namespace soms::detail
