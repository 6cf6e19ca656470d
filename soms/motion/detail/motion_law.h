/// \file
/// What the proof of motion_bounds.h needs to know of a motion: where the points of a body are,
/// seen from another, and how their velocities change.
#pragma once

#include "soms/base/pose.h"
#include "soms/motion/rigid_motion.h"

namespace soms::detail {

/// Covers the rounding of a handful of operations on numbers that are not negative.
inline constexpr double kMotionUp = 1 + 0x1p-40;

/// Covers what poses of the caller may be stretched by: 1e-6 in an entry of R^T R, twice.
inline constexpr double kStretch = 1 + 0x1p-18;

static_assert(kStretch > (1 + 1.5e-6) / (1 - 1.5e-6), "a longest vector beside a norm");

/// Velocities change by at most `all`, and by `by_arm` for each unit of the arm of a point.
struct Curvature {
  double all = 0;
  double by_arm = 0;

  [[nodiscard]] double of(double arm) const { return (all + by_arm * arm) * kMotionUp; }

  [[nodiscard]] Curvature operator*(double factor) const { return {all * factor, by_arm * factor}; }
};

/// Velocities at a time: that of a point x is drift + spin x (x - pivot).
struct Twist {
  Vec3 drift;
  Vec3 spin;
  Vec3 pivot;
};

/// A motion of a body, the mover, seen in a frame in which the other body rests. The frame is the
/// world where that one does so itself. Points follow curves x(t) in real numbers, t from 0 to 1.
class MotionLaw {
 public:
  MotionLaw() = default;
  MotionLaw(const MotionLaw&) = delete;
  MotionLaw& operator=(const MotionLaw&) = delete;
  virtual ~MotionLaw() = default;

  /// The map of the mover into the frame. As a real map, and by `Pose::apply`, it puts no point of
  /// the body farther than `slack` from x(t). It is a rotation but for `turn_margin`.
  [[nodiscard]] virtual Pose at(double t) const = 0;

  /// At least |x''| over [ta, tb].
  [[nodiscard]] virtual Curvature curvature(double ta, double tb) const = 0;

  /// At least the arm of a point of the mover: its distance from where it turns about.
  [[nodiscard]] virtual double arm(const Vec3& point) const = 0;

  /// At least the share of |x''| that counts along a direction of the frame, of length 1.
  [[nodiscard]] virtual double across(const Vec3& n) const;

  /// Velocities in the frame, as well as doubles give them. Nothing is proved by them.
  [[nodiscard]] virtual Twist twist_at(double t) const = 0;

  /// Poses in world that are decided at a time. Between 0 and 1 they put points of both bodies,
  /// together, no farther than `slack` from where the law has them.
  [[nodiscard]] virtual Pose mover_at(double t) const = 0;
  [[nodiscard]] virtual Pose other_at(double t) const = 0;

  /// The other body in the frame, where it rests.
  [[nodiscard]] virtual Pose resting_pose() const = 0;

  /// The frame in world.
  [[nodiscard]] virtual Pose frame_at(double t) const = 0;

  /// The motion of the mover, where it is one and the other body rests.
  [[nodiscard]] virtual const RigidMotion* alone() const;

  /// At least every coordinate of the mover in the frame, and every partial sum of one.
  [[nodiscard]] double reach() const { return reach_; }

  [[nodiscard]] double slack() const { return slack_; }

  /// Half the difference of two maps of `at` turns vectors by its norm, but for this.
  [[nodiscard]] double turn_margin() const { return turn_margin_; }

 protected:
  /// \errors ErrorKind::out_of_range where `reach` is above 2^300.
  void set_margins(double reach, double slack, double turn_margin);

 private:
  double reach_ = 0;
  double slack_ = 0;
  double turn_margin_ = 0;
};

}  // namespace soms::detail
