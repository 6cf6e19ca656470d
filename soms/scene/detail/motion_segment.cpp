#include "soms/scene/detail/motion_segment.h"

#include <algorithm>
#include <cmath>

namespace soms::detail {

namespace {

/// Covers the rounding of a handful of operations on numbers that are not negative.
constexpr double kRoundedUp = 1 + 0x1p-48;

/// Length of a vector, where squares of its components may be too small for a double.
double length_of(const Vec3& v) {
  const double most = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(most > 0)) {
    return 0;
  }
  const Vec3 u{v.x / most, v.y / most, v.z / most};
  return most * std::sqrt(dot(u, u));
}

double product(const Quaternion& a, const Quaternion& b) {
  return ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]) + a[3] * b[3];
}

Quaternion of_length_one(Quaternion q) {
  const double length = std::sqrt(product(q, q));
  for (double& x : q) {
    x /= length;
  }
  return q;
}

double distance_of(const Quaternion& a, const Quaternion& b) {
  const Quaternion d{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
  return std::sqrt(product(d, d));
}

/// The axis about which the body turns from `a` to `b`, in its own coordinates; its length is the
/// sine of half the angle.
Vec3 axis_between(const Quaternion& a, const Quaternion& b) {
  const Vec3 va{a[1], a[2], a[3]};
  const Vec3 vb{b[1], b[2], b[3]};
  return (a[0] * vb - b[0] * va) - cross(va, vb);
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

Quaternion quaternion_of(const Pose& pose) {
  const auto& m = pose.m;
  const double xx = m[0];
  const double yy = m[5];
  const double zz = m[10];
  // Four times a component and the others, whichever is the largest: none is lost to cancellation.
  if (xx + yy + zz > 0) {
    return of_length_one({1 + xx + yy + zz, m[9] - m[6], m[2] - m[8], m[4] - m[1]});
  }
  if (xx >= yy && xx >= zz) {
    return of_length_one({m[9] - m[6], 1 + xx - yy - zz, m[1] + m[4], m[2] + m[8]});
  }
  if (yy >= zz) {
    return of_length_one({m[2] - m[8], m[1] + m[4], 1 + yy - xx - zz, m[6] + m[9]});
  }
  return of_length_one({m[4] - m[1], m[2] + m[8], m[6] + m[9], 1 + zz - xx - yy});
}

// The motion puts a point x of the body at R(t)(x - c) + w(t), in real numbers: c is the pivot, and
// w(t) lies between start_ and end_, the moved pivots as rounded.
//
// Rounding, with u = 2^-53: the components of a quaternion `at` are off by at most 6u, so the
// entries of its matrix by at most 40u; w by at most 6u W, where no coordinate of the two ends
// exceeds W; the shift w - Rc adds at most u (W + 4C), and `Pose::apply` at most 5u (B + W + C),
// where B and C are the sums of the greatest |x|, |y|, |z| of the body and of the pivot. So a
// coordinate is off by at most 48u (B + C) + 12u W, a point by less than twice that. The slack
// below is more than twice as much again; 2^-1060 stands for what is lost below the normal numbers.
MotionSegment::MotionSegment(const MotionPath& path, std::size_t segment, const Box& bounds)
    : first_(path.poses[segment]),
      last_(path.poses[segment + 1]),
      from_(quaternion_of(first_)),
      to_(quaternion_of(last_)),
      pivot_(path.pivot),
      start_(first_.apply(pivot_)),
      end_(last_.apply(pivot_)) {
  if (product(from_, to_) < 0) {
    for (double& x : to_) {
      x = -x;
    }
  }
  const Vec3 axis = axis_between(from_, to_);
  const double sine = length_of(axis);
  double size = std::abs(pivot_.x) + std::abs(pivot_.y) + std::abs(pivot_.z);
  for (std::size_t k = 0; k < 3; ++k) {
    size += std::max(std::abs(bounds.lower[k]), std::abs(bounds.upper[k]));
  }
  // Distances from a point and from a line are convex: none is greater than at a corner.
  for (const Vec3& corner : corners(bounds)) {
    const Vec3 arm = corner - pivot_;
    radius_ = std::max(radius_, length_of(arm) * kRoundedUp + 0x1p-50 * size);
    if (sine > 0) {
      lever_ =
          std::max(lever_, length_of(cross({axis.x / sine, axis.y / sine, axis.z / sine}, arm)));
    }
  }
  // The components of the axis are off by some 16u, its direction by that share of its length.
  lever_ = sine > 0 ? std::min(radius_, lever_ * kRoundedUp + radius_ * (0x1p-47 / sine)) : radius_;
  length_ = length_of(end_ - start_) * kRoundedUp;
  slack_ = 0x1p-45 * (size + std::max(greatest(start_), greatest(end_))) + 0x1p-1060;
  first_slack_ = slack_of_end(first_, from_);
  last_slack_ = slack_of_end(last_, to_);
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
    return {0, first_, from_, first_slack_};
  }
  if (t >= 1) {
    return {1, last_, to_, last_slack_};
  }
  MotionPlace place{t, {}, from_, slack_};
  if (from_ != to_) {
    for (std::size_t k = 0; k < 4; ++k) {
      place.turn[k] = from_[k] + t * (to_[k] - from_[k]);
    }
    place.turn = of_length_one(place.turn);
  }
  const Quaternion& q = place.turn;
  place.pose = Pose::from_quaternion(q[0], q[1], q[2], q[3]);
  for (std::size_t row = 0; row < 3; ++row) {
    const double* const r = &place.pose.m[4 * row];
    const double at = start_[row] + t * (end_[row] - start_[row]);
    place.pose.m[4 * row + 3] = at - ((r[0] * pivot_.x + r[1] * pivot_.y) + r[2] * pivot_.z);
  }
  return place;
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
