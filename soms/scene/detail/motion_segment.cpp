#include "soms/scene/detail/motion_segment.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Covers the rounding of a handful of operations on numbers that are not negative.
constexpr double kRoundedUp = 1 + 0x1p-48;

double distance_of(const Quaternion& a, const Quaternion& b) {
  const Quaternion d{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
  return std::sqrt(product(d, d));
}

std::array<Vec3, 8> corners(const Box& box) {
  std::array<Vec3, 8> points;
  for (std::size_t k = 0; k < 8; ++k) {
    points[k] = {(k & 1U) != 0 ? box.upper.x : box.lower.x,
                 (k & 2U) != 0 ? box.upper.y : box.lower.y,
                 (k & 4U) != 0 ? box.upper.z : box.lower.z};
  }
  return points;
}

double greatest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

}  // namespace

// The motion puts a point x of the body at R(t)(x - c) + w(t), in real numbers: c is the pivot, and
// w(t) lies between `start` and `end`, the moved pivots as rounded.
//
// Rounding, with u = 2^-53: the components of a quaternion `at` are off by at most 6u, so the
// entries of its matrix by at most 40u; w by at most 6u W, where no coordinate of the two ends
// exceeds W; the shift w - Rc adds at most u (W + 4C), and `Pose::apply` at most 5u (B + W + C),
// where B and C are the sums of the greatest |x|, |y|, |z| of the body and of the pivot. So a
// coordinate is off by at most 48u (B + C) + 12u W, a point by less than twice that. The slack
// below is more than twice as much again; 2^-1060 stands for what is lost below the normal numbers.
MotionSegment::MotionSegment(const MotionPath& path, std::size_t segment, const Box& bounds)
    : motion_(RigidMotion::between(path.poses[segment], path.poses[segment + 1], path.pivot)) {
  const Vec3& pivot = motion_.pivot();
  const Vec3& start = motion_.pivot_from();
  const Vec3& end = motion_.pivot_to();
  const Vec3 axis = axis_between(motion_.from(), motion_.to());
  const double sine = length_of(axis);
  double size = std::abs(pivot.x) + std::abs(pivot.y) + std::abs(pivot.z);
  for (std::size_t k = 0; k < 3; ++k) {
    size += std::max(std::abs(bounds.lower[k]), std::abs(bounds.upper[k]));
  }
  // Distances from a point and from a line are convex: none is greater than at a corner.
  for (const Vec3& corner : corners(bounds)) {
    const Vec3 arm = corner - pivot;
    radius_ = std::max(radius_, length_of(arm) * kRoundedUp + 0x1p-50 * size);
    if (sine > 0) {
      lever_ =
          std::max(lever_, length_of(cross({axis.x / sine, axis.y / sine, axis.z / sine}, arm)));
    }
  }
  // The components of the axis are off by some 16u, its direction by that share of its length.
  lever_ = sine > 0 ? std::min(radius_, lever_ * kRoundedUp + radius_ * (0x1p-47 / sine)) : radius_;
  length_ = length_of(end - start) * kRoundedUp;
  slack_ = 0x1p-45 * (size + std::max(greatest(start), greatest(end))) + 0x1p-1060;
  first_slack_ = slack_of_end(motion_.start(), motion_.from());
  last_slack_ = slack_of_end(motion_.end(), motion_.to());
}

/// The poses of the path need not be rotations to the last bit: a point may be off by the norm of
/// the difference for each unit of its distance from the pivot.
double MotionSegment::slack_of_end(const Pose& pose, const Quaternion& turn) const {
  const Pose rotation = Pose::from_quaternion(turn[0], turn[1], turn[2], turn[3]);
  double sum = 0;
  for (std::size_t k = 0; k < 12; ++k) {
    const double off = k % 4 == 3 ? 0 : pose.m[k] - rotation.m[k];
    sum += off * off;
  }
  return std::sqrt(sum) * radius_ * kRoundedUp + slack_;
}

MotionPlace MotionSegment::at(double t) const {
  if (t <= 0) {
    return {0, motion_.start(), motion_.from(), first_slack_};
  }
  if (t >= 1) {
    return {1, motion_.end(), motion_.to(), last_slack_};
  }
  return {t, motion_.law_at(t), motion_.quaternion_at(t), slack_};
}

// Between a and b, a turn of the angle 4f about one axis is made in two parts, of which the chords
// of a point at the distance r from the axis are 2r sin f1 and 2r sin f2 with f1 + f2 = 2f: at most
// 4r sin f together, as the sine is concave. The quaternions are at the angle 2f from each other,
// and so |qa - qb| is 2 sin f. They are off by at most 24u together. The pivot's parts are on a
// straight line: their sum is its length. The point moves with the pivot and about it.
double MotionSegment::most_motion(const MotionPlace& a, const MotionPlace& b) const {
  const double turn = distance_of(a.turn, b.turn) * kRoundedUp + 0x1p-47;
  return (length_ * (b.t - a.t) + 2 * lever_ * turn) * kRoundedUp;
}

}  // namespace soms::detail
