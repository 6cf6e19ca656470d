#include "soms/motion/rigid_motion.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"
#include "soms/motion/detail/quaternion.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace soms {

namespace {

void check_finite(const Vec3& v, const char* what) {
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
    throw Error(ErrorKind::not_finite, std::string("motion: ") + what + " is not finite",
                "give finite numbers");
  }
}

}  // namespace

RigidMotion RigidMotion::along(const Pose& start, const Vec3& by) {
  const PlainArithmetic plain;
  check(start);
  check_finite(by, "the vector");
  RigidMotion motion;
  motion.straight_ = true;
  motion.first_ = start;
  motion.by_ = by;
  motion.from_ = motion.to_ = detail::quaternion_of(start);
  motion.last_ = motion.law_at(1);
  motion.pivot_from_ = start.shift();
  motion.pivot_to_ = motion.last_.shift();
  check(motion.last_);
  return motion;
}

RigidMotion RigidMotion::between(const Pose& start, const Pose& end, const Vec3& pivot) {
  const PlainArithmetic plain;
  check(start);
  check(end);
  check_finite(pivot, "the pivot");
  RigidMotion motion;
  motion.first_ = start;
  motion.last_ = end;
  motion.pivot_ = pivot;
  motion.from_ = detail::quaternion_of(start);
  motion.to_ = detail::quaternion_of(end);
  if (detail::product(motion.from_, motion.to_) < 0) {
    for (double& x : motion.to_) {
      x = -x;
    }
  }
  motion.pivot_from_ = start.apply(pivot);
  motion.pivot_to_ = end.apply(pivot);
  check_finite(motion.pivot_from_, "the moved pivot");
  check_finite(motion.pivot_to_, "the moved pivot");
  return motion;
}

RigidMotion RigidMotion::turn(const Pose& start, const Vec3& center, const Vec3& axis,
                              double angle) {
  const PlainArithmetic plain;
  check(start);
  check_finite(center, "the center");
  if (!(std::abs(angle) < std::numbers::pi)) {
    throw Error(ErrorKind::usage, "motion: the angle is not below a half turn",
                "cut a longer turn into several motions");
  }
  const Vec3 pivot = start.inverse().apply(center);
  Pose end = Pose::from_axis_angle(axis, angle) * start;
  // The center rests.
  const Vec3 turned = end.apply(pivot);
  for (std::size_t row = 0; row < 3; ++row) {
    end.m[4 * row + 3] += center[row] - turned[row];
  }
  return between(start, end, pivot);
}

RigidMotion::Quaternion RigidMotion::quaternion_at(double t) const {
  Quaternion q = from_;
  if (from_ == to_) {
    return q;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    q[k] = from_[k] + t * (to_[k] - from_[k]);
  }
  return detail::of_length_one(q);
}

Pose RigidMotion::law_at(double t) const {
  const PlainArithmetic plain;
  if (straight_) {
    Pose pose = first_;
    for (std::size_t row = 0; row < 3; ++row) {
      pose.m[4 * row + 3] += t * by_[row];
    }
    return pose;
  }
  const Quaternion q = quaternion_at(t);
  Pose pose = Pose::from_quaternion(q[0], q[1], q[2], q[3]);
  for (std::size_t row = 0; row < 3; ++row) {
    const double* const r = &pose.m[4 * row];
    const double at = pivot_from_[row] + t * (pivot_to_[row] - pivot_from_[row]);
    pose.m[4 * row + 3] = at - ((r[0] * pivot_.x + r[1] * pivot_.y) + r[2] * pivot_.z);
  }
  return pose;
}

Pose RigidMotion::pose_at(double t) const {
  return t <= 0 ? first_ : t >= 1 ? last_ : law_at(t);
}

}  // namespace soms
