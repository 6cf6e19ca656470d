/// \file
/// The brute-force twin of `first_contact`: every pair of triangles, no tree, whole numbers. What
/// tests believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/motion/first_contact.h"
#include "soms/query/body.h"

namespace soms::reference {

/// Same meaning as `soms::first_contact` without a clearance, for the law of the motion in real
/// numbers. Times the square of the quaternion's length, each corner of the mover is a cubic in t
/// whose coefficients are sums and products of doubles. Two triangles are free from ta to tb where
/// for a direction the differences of their corners are polynomials that are above 0 there in
/// Bernstein's form. They touch where an edge of one meets the other by signs of volumes. Times are
/// halved until one of the two holds.
///
/// `free` and `started` are exact: the first is about the law alone, the second about the pose of
/// the start. `contact` is free of contact until `t.lower`, and in contact at `t.upper`. `grazing`
/// stands for a touch that no halving decides, as where corners glide over a face.
///
/// \errors  As `soms::first_contact`; timed_out.
/// \cost    O(n m), some milliseconds a pair.
[[nodiscard]] FirstContact first_contact_by_brute_force(const Shape& mover,
                                                        const RigidMotion& motion,
                                                        const Body& fixed,
                                                        const Limits& limits = {});

}  // namespace soms::reference
