#include "soms/motion/detail/swept_bounds.h"

#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/moved_bounds.h"
#include "soms/motion/detail/widened.h"
#include "soms/query/body.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

namespace {

/// What both boxes hold.
Box shared_by(const Box& a, const Box& b) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
    box.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
  }
  return box;
}

}  // namespace

RigidMotion way_between(const Pose& start, const Pose& end, const Shape& body) {
  return RigidMotion::between(start, end, body.bounds().empty() ? Vec3() : body.bounds().center());
}

Box swept_bounds(const Shape& body, const RigidMotion& way) {
  const Box& own = body.bounds();
  if (own.empty()) {
    return {};
  }
  const Body nothing;
  const RigidLaw law(body, way, nothing);
  const Vec3& pivot = way.pivot();
  Vec3 farthest;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    farthest[axis] = std::max(own.upper[axis] - pivot[axis], pivot[axis] - own.lower[axis]);
  }
  const double radius = length_of(farthest) * kMotionUp;
  const double slack = 2 * law.slack();
  const double bow = MotionBounds::bow(law.curvature(0, 1).of(law.arm(pivot) + radius), 1);
  Box chord = moved_bounds(way.law_at(0), own);
  chord.grow(moved_bounds(way.law_at(1), own));
  Box ball;
  ball.grow(way.pivot_from());
  ball.grow(way.pivot_to());
  Vec3 margin;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 along;
    along[axis] = 1;
    margin[axis] = (bow * law.across(along) + slack) * kMotionUp;
  }
  Box box = shared_by(widened(chord, margin), widened(ball, (radius + slack) * kMotionUp));
  box.grow(moved_bounds(way.start(), own));
  box.grow(moved_bounds(way.end(), own));
  return box;
}

}  // namespace soms::detail
