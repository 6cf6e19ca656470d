/// \file
/// Whether a turning triangle surely misses a resting one: a filter before whole numbers.
#pragma once

#include "soms/base/vector.h"
#include "soms/motion/rigid_motion.h"

namespace soms::detail {

/// True only if the two triangles of `exact_motion` share no point from `from` to `until`. False
/// says nothing. Some microseconds, where whole numbers take some hundred.
///
/// A direction n parts the two on a stretch if n.(x(t) - y) is above 0 for each corner x of the one
/// that moves and each corner y of the other. Times |q|^2 that is |q|^2 n.(w - y) + n.(M(q) (a -
/// c)), by the names of turn_polynomials.h: of degree 3, and above 0 where its four coefficients in
/// Bernstein's form are. With q and w at both ends of the stretch, those of |q|^2 and of M(q) are
/// their bilinear forms. Directions are the normals of both faces and what is across two edges;
/// that with the widest gap in the middle is taken. A stretch that is not parted is halved.
///
/// Rounding. Coefficients are sums of products of double-doubles, each operation within 2^-102 of
/// its value, and no more than 40 of them lead to one. A direction is what its double-doubles say,
/// so it has no error. Coordinates of q0, q1 and their difference are at most 1, 1 and 2, so those
/// of q are sums of parts of 3 in all, |q|^2 of 36, and a coordinate of M(q) v of 126 v. Those of w
/// have parts of three times its greatest coordinate. Let N be the sum of the coordinates of n, and
/// S that of the greatest ones of w, y and a - c. The parts of a coefficient are 3 (3 36 + 126) N S
/// < 2^10 N S in all, and it is off by less than 2^-102 40 2^10 N S < 2^-86 N S. Below 2^200
/// nothing overflows, and what underflows is less than 2^-800 in a coefficient.
[[nodiscard]] bool surely_parted(const RigidMotion& motion, const Triangle& moving,
                                 const Triangle& resting, double from, double until);

}  // namespace soms::detail
