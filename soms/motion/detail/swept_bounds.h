/// \file
/// The world box of a body on its way from one pose to another, in constant time.
#pragma once

#include "soms/base/box.h"
#include "soms/motion/rigid_motion.h"
#include "soms/tree/shape.h"

namespace soms::detail {

/// From `start` to `end`, about the center of the bounds of `body`.
[[nodiscard]] RigidMotion way_between(const Pose& start, const Pose& end, const Shape& body);

/// A box that holds the body at every time of the way: where the law has it in real numbers, and at
/// every pose of `pose_at`, as `Pose::apply` rounds. So bodies whose boxes are apart are free all
/// the way, and both of them may move. Names of the proof are those of rigid_law.h.
///
/// Two boxes hold x(t), the place of a point a of the body by the law, and so does what they share.
///
/// By the chord. x(t) leaves the straight line from x(0) to x(1) by at most max |x''| / 8, and
/// along an axis by the share of |x''| that counts there (`across`). `law_at(0)` and `law_at(1)`
/// move a, by `apply`, to within the slack of x(0) and x(1), into their `moved_bounds`. The line is
/// within the hull of both, grown by the slack. |x''| is at most the curvature by the arm of a,
/// which is at most the arm of the pivot and the distance of a from the pivot: a distance from a
/// line grows no faster than the way.
///
/// By the ball. x(t) = w(t) + R(t) (a - c), where w(t) is between w0 and w1, and R(t) is a
/// rotation. So x(t) is within |a - c| of a point of the hull of w0 and w1. This is the tighter one
/// where the body turns far.
///
/// `pose_at(t)` puts a within the slack of x(t): twice the slack is added in all. At 0 and 1 it is
/// the caller's pose, which may be stretched by 1e-6; `moved_bounds` of the two are united with the
/// rest.
///
/// Rounding. The radius is the length of three rounded differences, and the bow a handful of
/// products, none negative: `kMotionUp` is 2^13 roundings. Underflow of these is below 2^-1060,
/// which the slack ends in. `widened` rounds outward.
/// \pre    The two poses passed their checks for this body.
/// \errors ErrorKind::out_of_range where the body may come beyond 2^300 on its way.
[[nodiscard]] Box swept_bounds(const Shape& body, const RigidMotion& way);

}  // namespace soms::detail
