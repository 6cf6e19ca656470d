/// \file
/// The first contact of a triangle that turns with one that rests, in whole numbers.
#pragma once

#include "soms/base/bracket.h"
#include "soms/base/vector.h"
#include "soms/motion/rigid_motion.h"

#include <optional>

namespace soms::detail {

/// The doubles next to the least t in [from, until] at which the two closed triangles share a
/// point; nothing if there is none. `moving`, in the coordinates of its body, goes by the law of
/// the motion in real numbers (motion_bounds.h), and nothing is rounded but the bracket.
///
/// Why features suffice. That an edge of one meets the other at `from` is decided by itself. If
/// they share no point at `from`, a plane parts them at the first contact and holds all common
/// points. What the triangles have in that plane are corners, edges or faces, so a corner of one
/// lies in the other, or two edges cross. A triangle without area is its longest edge, or a point.
/// Times |q|^2 all places are cubics in time:
///   - a corner in a face: it is in the plane, a cubic, and beside no edge, three cubics;
///   - two edges: their volume is 0, of degree 5, and each meets the line of the other inside of
///     it, two conditions of degree 5 for each. Edges that are parallel then are left out. If they
///     touch, a corner of one lies in the other: in its face, or in another edge not parallel to
///     it, or both are segments;
///   - a corner in a segment, two points: three equations, where neither triangle has a face.
/// Where an equation holds throughout, as for what turns in a plane, the others begin to hold at
/// their own roots (first_moment.h).
///
/// Numbers are as long as the coordinates need, and nothing is cut. Hundreds of bits serve ordinary
/// ones, in some tenths of a millisecond. A kiss of coordinates of all magnitudes may take seconds.
/// \pre The motion is not straight, 0 <= from <= until <= 1, coordinates are finite.
[[nodiscard]] std::optional<Bracket> exact_motion(const RigidMotion& motion, const Triangle& moving,
                                                  const Triangle& resting, double from,
                                                  double until);

}  // namespace soms::detail
