/// \file
/// Rotations as quaternions, by additions, products, quotients and square roots alone.
#pragma once

#include "soms/base/pose.h"
#include "soms/motion/rigid_motion.h"

#include <cmath>

namespace soms::detail {

/// (w, x, y, z), of length 1 but for rounding.
using Quaternion = RigidMotion::Quaternion;

[[nodiscard]] inline double product(const Quaternion& a, const Quaternion& b) {
  return ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]) + a[3] * b[3];
}

[[nodiscard]] inline Quaternion of_length_one(Quaternion q) {
  const double length = std::sqrt(product(q, q));
  for (double& x : q) {
    x /= length;
  }
  return q;
}

/// The axis about which a body turns from `a` to `b`, in its own coordinates; its length is the
/// sine of half the angle.
[[nodiscard]] inline Vec3 axis_between(const Quaternion& a, const Quaternion& b) {
  const Vec3 va{a[1], a[2], a[3]};
  const Vec3 vb{b[1], b[2], b[3]};
  return (a[0] * vb - b[0] * va) - cross(va, vb);
}

/// Length of a vector whose squares are too small for a double.
[[nodiscard]] double length_of_small(const Vec3& v);

/// Length of a vector, which has no coordinate above 2^500.
[[nodiscard]] inline double length_of(const Vec3& v) {
  const double squared = dot(v, v);
  return squared > 0x1p-900 ? std::sqrt(squared) : length_of_small(v);
}

/// The quaternion of the rotation of a pose; nearly that of a pose that is nearly rigid.
[[nodiscard]] Quaternion quaternion_of(const Pose& pose);

}  // namespace soms::detail
