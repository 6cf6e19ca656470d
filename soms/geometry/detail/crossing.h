/// \file
/// What two triangles share that cross in general position: a segment.
///
/// Sides of corners against planes, n.w with n = e x f, and of edges against edges, (e x f).r, must
/// exceed what doubles may be off by (feature_proof.h: 49 u of the product of the lengths, in the
/// same range). Then each triangle has one corner alone on its side of the other's plane, whose two
/// edges cross that plane. The four crossings lie on one line; one of them is inside the other
/// triangle exactly where its edge passes the two edges of the other on different sides. The two
/// that are inside are the ends.
///
/// An end is P + s E with s = p / (p - q), p and q the sides of E's corners in pairs of doubles,
/// u = 2^-102. Coordinates of E, e, f, w are exact but for u; in units of u times the product L of
/// the lengths n is off by 10, n.w by 3 (10 + 2 * 3) = 48, p - q by 97. As p and q differ in sign,
/// |p - q| = |p| + |q|, which must exceed 2^-30 L: s is off by less than 2^-64.
#pragma once

#include "soms/base/vector.h"

#include <optional>

namespace soms::detail {

/// The middle of the shared segment, off by less than 2^-60 of the largest difference of corners
/// but for the rounding of the result; nothing where doubles do not show that the triangles cross
/// so, or where an end is hard to find.
/// \pre Coordinates are finite and of magnitude at most 2^300.
[[nodiscard]] std::optional<Vec3> crossing_middle(const Triangle& a, const Triangle& b);

}  // namespace soms::detail
