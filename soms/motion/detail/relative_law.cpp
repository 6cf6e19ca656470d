#include "soms/motion/detail/relative_law.h"

#include "soms/motion/detail/motion_interval.h"

#include <algorithm>
#include <cstddef>

namespace soms::detail {

namespace {

constexpr double kShiftedSlack = 0x1p-44;
constexpr double kSeenSlack = 0x1p-41;
constexpr double kSeenTurnMargin = 0x1p-42;

static_assert(kShiftedSlack >= 1.5 * (256 + 4) * kMotionUnit, "both slacks and a difference");
static_assert(kSeenSlack >= 2 * (1600 + 256) * kMotionUnit, "a product with an inverse, twice");
static_assert(kSeenTurnMargin >= 4 * 300 * kMotionUnit, "rounding of a difference of products");

/// The place of the pivot.
Vec3 pivot_at(const RigidMotion& motion, double t) {
  return motion.pivot_from() + (motion.pivot_to() - motion.pivot_from()) * t;
}

}  // namespace

RelativeLaw::RelativeLaw(const Shape& mover, const RigidMotion& motion, const Shape& other,
                         const RigidMotion& motion_of_other)
    : a_(mover, motion), b_(other, motion_of_other) {
  const double both = a_.reach() + b_.reach();
  if (b_.turns()) {
    set_margins(8 * both, kSeenSlack * both + kTinySlack, kSeenTurnMargin);
  } else {
    set_margins(2 * both, kShiftedSlack * both + kTinySlack, a_.turns() ? kTurnMargin : 0);
  }
}

Vec3 RelativeLaw::shift_at(double t) const {
  return b_.motion().law_at(t).shift() - b_.motion().law_at(0).shift();
}

Pose RelativeLaw::at(double t) const {
  Pose seen = a_.motion().law_at(t);
  if (b_.turns()) {
    return b_.motion().law_at(t).inverse() * seen;
  }
  const Vec3 shift = shift_at(t);
  for (std::size_t row = 0; row < 3; ++row) {
    seen.m[4 * row + 3] -= shift[row];
  }
  return seen;
}

Pose RelativeLaw::resting_pose() const {
  return b_.turns() ? Pose() : b_.motion().law_at(0);
}

Pose RelativeLaw::frame_at(double t) const {
  if (b_.turns()) {
    return b_.motion().law_at(t);
  }
  const Vec3 shift = shift_at(t);
  return Pose::translation(shift.x, shift.y, shift.z);
}

Curvature RelativeLaw::curvature(double ta, double tb) const {
  const TurnRate a = a_.rate(ta, tb);
  const TurnRate b = b_.rate(ta, tb);
  const double both = a.speed + b.speed;
  const double by_arm = (both * both + (a.growth + b.growth)) * kMotionUp;
  if (!b_.turns()) {
    return {0, by_arm};
  }
  const auto apart = [&](double t) {
    return length_of(pivot_at(a_.motion(), t) - pivot_at(b_.motion(), t));
  };
  const double farthest = std::max(apart(ta), apart(tb)) + slack();
  const double drift = length_of(a_.twist_at(0).drift - b_.twist_at(0).drift) + slack();
  return {((b.speed * b.speed + b.growth) * farthest + 2 * b.speed * drift) * kMotionUp, by_arm};
}

double RelativeLaw::arm(const Vec3& point) const {
  if (!b_.turns()) {
    return a_.arm(point);
  }
  return length_of(point - a_.motion().pivot()) * kStretch + slack();
}

double RelativeLaw::across(const Vec3& n) const {
  return b_.turns() ? 1 : a_.across(n);
}

Twist RelativeLaw::twist_at(double t) const {
  const Twist a = a_.twist_at(t);
  const Twist b = b_.twist_at(t);
  if (!b_.turns()) {
    return {a.drift - b.drift, a.spin, a.pivot - shift_at(t)};
  }
  const Pose pose = b_.motion().law_at(t);
  const Vec3 drift = (a.drift - b.drift) - cross(b.spin, a.pivot - b.pivot);
  return {turned_back(pose, drift), turned_back(pose, a.spin - b.spin),
          turned_back(pose, a.pivot - pose.shift())};
}

}  // namespace soms::detail
