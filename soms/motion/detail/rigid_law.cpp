#include "soms/motion/detail/rigid_law.h"

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
double reach_of(const Shape& body, const RigidMotion& motion) {
  if (motion.straight()) {
    return moved_extent(motion.start(), body.bounds()) + greatest_of(motion.by());
  }
  return sum_of(farthest(body.bounds())) + sum_of(motion.pivot()) +
         std::max(greatest_of(motion.pivot_from()), greatest_of(motion.pivot_to()));
}

}  // namespace

TurnBounds::TurnBounds(const Shape& body, const RigidMotion& motion)
    : motion_(&motion), reach_(reach_of(body, motion)) {
  if (!turns()) {
    return;
  }
  const Vec3 axis = axis_between(motion.from(), motion.to());
  const double sine = length_of(axis);
  if (sine > 0) {
    axis_ = {axis.x / sine, axis.y / sine, axis.z / sine};
    axis_in_world_ = turned(motion.law_at(0), axis_);
  }
  sine_ = sine * kMotionUp + kSineMargin;
  off_axis_ = sine > kSineMargin ? 0x1p-46 / sine * kMotionUp : 1;
  for (std::size_t k = 0; k < 4; ++k) {
    step_[k] = motion.to()[k] - motion.from()[k];
  }
}

TurnRate TurnBounds::rate(double ta, double tb) const {
  if (!turns()) {
    return {};
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
  return {speed * kMotionUp, speed * (change + kSineMargin) / least * kMotionUp};
}

double TurnBounds::across(const Vec3& n) const {
  return std::min(1.0, length_of(cross(axis_in_world_, n)) * kMotionUp + (kTurnMargin + off_axis_));
}

double TurnBounds::arm_of_pivot(const Vec3& point) const {
  return turns() ? length_of(point - motion_->pivot()) * kMotionUp + kSlackShare * reach_ : 0;
}

double TurnBounds::arm(const Vec3& point) const {
  const double whole = arm_of_pivot(point);
  const double across = length_of(cross(axis_, point - motion_->pivot())) * kMotionUp;
  return std::min(whole, across + whole * off_axis_ + kSlackShare * reach_);
}

Twist TurnBounds::twist_at(double t) const {
  const Vec3 drift =
      motion_->straight() ? motion_->by() : motion_->pivot_to() - motion_->pivot_from();
  if (!turns()) {
    return {drift, {}, {}};
  }
  double squared = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double q = motion_->from()[k] + t * step_[k];
    squared += q * q;
  }
  return {drift, axis_in_world_ * (2 * sine_ / squared), motion_->pivot_from() + drift * t};
}

RigidLaw::RigidLaw(const Shape& mover, const RigidMotion& motion, const Body& fixed)
    : bounds_(mover, motion), fixed_(fixed) {
  set_margins(bounds_.reach(), bounds_.slack(), bounds_.turns() ? kTurnMargin : 0);
}

Curvature RigidLaw::curvature(double ta, double tb) const {
  const TurnRate rate = bounds_.rate(ta, tb);
  return {0, (rate.speed * rate.speed + rate.growth) * kMotionUp};
}

}  // namespace soms::detail
