#include "soms/motion/detail/motion_bounds.h"

#include "soms/base/error.h"
#include "soms/motion/detail/motion_interval.h"
#include "soms/query/detail/relative_pose.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace soms::detail {

namespace {

double greatest_of(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double sum_of(const Vec3& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

/// At least every coordinate of the body on its way, and every partial sum of one.
double reach_of(const Shape& mover, const RigidMotion& motion) {
  if (motion.straight()) {
    return moved_extent(motion.start(), mover.bounds()) + greatest_of(motion.by());
  }
  return sum_of(farthest(mover.bounds())) + sum_of(motion.pivot()) +
         std::max(greatest_of(motion.pivot_from()), greatest_of(motion.pivot_to()));
}

}  // namespace

MotionBounds::MotionBounds(const Shape& mover, const RigidMotion& motion, const Body& fixed,
                           double clearance)
    : motion_(&motion), clearance_(clearance), reach_(reach_of(mover, motion)) {
  if (!(reach_ <= kMaxCoordinate)) {
    throw Error(ErrorKind::out_of_range, "motion: the body may come beyond 2^300 on its way",
                "use a larger unit, or a pivot nearer to the body");
  }
  if (!motion.straight()) {
    const Vec3 axis = axis_between(motion.from(), motion.to());
    const double sine = length_of(axis);
    if (sine > 0) {
      axis_ = {axis.x / sine, axis.y / sine, axis.z / sine};
      axis_in_world_ = turned(motion.law_at(0), axis_);
    }
    sine_ = sine * kMotionUp + kSineMargin;
    for (std::size_t k = 0; k < 4; ++k) {
      step_[k] = motion.to()[k] - motion.from()[k];
    }
  }
  slack_ = kSlackShare * reach_ + kTinySlack;
  const double size = reach_ + moved_extent(fixed.pose, fixed.shape.bounds()) + clearance;
  box_margin_ = (clearance + (2 * slack_ + kBoxShare * size)) * kMotionUp + kTinyMargin;
  rounding_ = (2 * slack_ + kPairShare * size) + kTinyMargin;
  pair_margin_ = clearance + rounding_;
}

double MotionBounds::curvature(double ta, double tb) const {
  if (motion_->straight()) {
    return 0;
  }
  const Quaternion& from = motion_->from();
  const double along = product(from, step_);
  const double squared = product(step_, step_);
  // Where q is shortest, if that lies between; any other time gives no smaller N by more than its
  // error.
  const double at = squared > 0 ? std::clamp(-along / squared, ta, tb) : ta;
  Quaternion q = from;
  for (std::size_t k = 0; k < 4; ++k) {
    q[k] += at * step_[k];
  }
  const double least = product(q, q) * (1 - kSineMargin);
  const double change =
      2 * std::max(std::abs(along + ta * squared), std::abs(along + tb * squared));
  const double speed = 2 * sine_ / least;
  const double growth = speed * (change + kSineMargin) / least;
  return (speed * speed + growth) * kMotionUp;
}

double MotionBounds::across(const Vec3& n) const {
  const double sine = sine_ - kSineMargin;
  if (!(sine > kSineMargin)) {
    return 1;
  }
  return std::min(1.0,
                  length_of(cross(axis_in_world_, n)) * kMotionUp + (kTurnMargin + 0x1p-46 / sine));
}

double MotionBounds::arm(const Vec3& point) const {
  if (motion_->straight()) {
    return 0;
  }
  const Vec3 from_pivot = point - motion_->pivot();
  const double whole = length_of(from_pivot) * kMotionUp + kSlackShare * reach_;
  const double sine = sine_ - kSineMargin;
  if (!(sine > kSineMargin)) {
    return whole;
  }
  const double across = length_of(cross(axis_, from_pivot)) * kMotionUp;
  return std::min(whole, across + whole * (0x1p-46 / sine) + kSlackShare * reach_);
}

}  // namespace soms::detail
