#include "soms/motion/detail/pair_advance.h"

#include "soms/geometry/triangle_distance.h"
#include "soms/geometry/triangle_overlap.h"
#include "soms/motion/detail/exact_motion.h"
#include "soms/motion/detail/exact_sweep.h"
#include "soms/motion/detail/motion_interval.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace soms::detail {

namespace {

/// Steps of one pair in one window. What slides along at next to no gap is decided in whole numbers
/// beyond them, or left open but for a contact that is found farther on.
constexpr int kMostSteps = 2000;

/// Further ones toward a contact that was found, so that its bracket is narrow.
constexpr int kMoreSteps = 20'000;

/// A gap that is above the margin by this much of the rounding counts as none: steps would be too
/// short.
constexpr double kNextToNone = 0x1p-2;

/// What a step leaves of the gap, for the proof.
constexpr double kLeft = 0x1p-10;

/// How often a step that cannot be proved is halved.
constexpr int kHalvings = 40;

/// The first look for a contact is after this much of the time in which the rounding is crossed.
constexpr double kFirstLook = 0x1p-3;

/// Until so many times that, no gap is looked for again.
constexpr double kSoon = 16;

/// A share of the speed of a corner that is next to none.
constexpr double kSlowly = 0x1p-6;

/// How often a contact is drawn nearer to a time without one.
constexpr int kDraws = 5;

/// The number with the fewest binary digits in [from, to], 0 <= from <= to <= 1.
double simplest(double from, double to) {
  for (int digits = 0; digits < 60; ++digits) {
    const double unit = std::ldexp(1.0, -digits);
    const double at = std::ceil(from / unit) * unit;
    if (at <= to) {
      return at;
    }
  }
  return from;
}

}  // namespace

PairAdvance::PairAdvance(const MotionBounds& bounds, const Shape& mover, const Body& resting,
                         const TrianglePair& ids, ContactGoal& goal, Cost& cost)
    : bounds_(bounds),
      law_(bounds.law()),
      ids_(ids),
      moving_(corners_of(mover.mesh().triangle(ids.a))),
      other_(corners_of(resting.shape.mesh().triangle(ids.b))),
      resting_(placed(other_, resting.pose)),
      goal_(goal),
      cost_(cost) {
  for (const Vec3& corner : moving_) {
    arm_ = std::max(arm_, law_.arm(corner));
  }
}

PairAdvance::Place PairAdvance::at(double t) const {
  return {t, placed(moving_, law_.at(t))};
}

bool PairAdvance::touches(double t) {
  const Triangle x = triangle_of(placed(moving_, law_.mover_at(t)));
  const Triangle y = triangle_of(placed(other_, law_.other_at(t)));
  if (bounds_.clearance() > 0) {
    return triangles_within(x, y, bounds_.clearance());
  }
  return triangles_overlap(x, y, &cost_.exact_tests);
}

Corners PairAdvance::velocities(const Place& place) const {
  const Twist twist = law_.twist_at(place.t);
  Corners velocities;
  for (std::size_t k = 0; k < 3; ++k) {
    velocities[k] = twist.drift + cross(twist.spin, place.corners[k] - twist.pivot);
  }
  return velocities;
}

double PairAdvance::first_look(const Place& place, const Vec3& n) const {
  double closing = 0;
  double fastest = 0;
  for (const Vec3& v : velocities(place)) {
    closing = std::max(closing, -dot(n, v));
    fastest = std::max(fastest, length_of(v));
  }
  const double least = std::max(place.t, 0x1p-30) * 0x1p-52;
  // What hardly nears is looked at as soon as can be.
  return closing > kSlowly * fastest ? std::max(least, kFirstLook * (bounds_.rounding() / closing))
                                     : least;
}

double PairAdvance::reach(const Place& place, const Parting& parting) const {
  const Vec3& n = parting.direction;
  const Corners velocities = this->velocities(place);
  const double top =
      std::max({0.0, dot(n, resting_[1] - resting_[0]), dot(n, resting_[2] - resting_[0])});
  const double a = curvature_ * law_.across(n) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const double gap = dot(n, place.corners[k] - resting_[0]) - top - bounds_.pair_margin() -
                       bounds_.rounding() * 0x1p-4;
    const double speed = dot(n, velocities[k]);
    // Where gap + speed s - a s^2 is spent.
    double s = std::numeric_limits<double>::infinity();
    if (a > 0) {
      // Squares of tiny ones are 0.
      const double root = length_of({speed, 2 * std::sqrt(a) * std::sqrt(std::max(gap, 0.0)), 0});
      s = speed >= 0 ? (speed + root) / (2 * a) : 2 * gap / (root - speed);
    } else if (speed < 0) {
      s = gap / -speed;
    }
    least = std::min(least, s);
  }
  return least;
}

bool PairAdvance::step(Place& place, const Parting& parting, double until) const {
  const double bend = curvature_ * law_.across(parting.direction) * kMotionUp;
  double length = reach(place, parting) * (curvature_ > 0 ? 1 - kLeft : 1 - 0x1p-40);
  for (int k = 0; k < kHalvings; ++k, length /= 2) {
    const double t = std::min(until, place.t + length);
    if (!(t > place.t)) {
      return false;
    }
    Place next = at(t);
    const double gap = std::min(parting.gap, gap_along(parting.direction, next.corners, resting_));
    const double bow = MotionBounds::bow(bend, t - place.t);
    if (gap - bow > bounds_.pair_margin()) {
      place = next;
      return true;
    }
  }
  return false;
}

double PairAdvance::earliest(double without, double with) {
  for (int k = 0; k < kDraws; ++k) {
    const double middle = without + (with - without) / 2;
    if (!(middle > without && middle < with)) {
      break;
    }
    (touches(middle) ? with : without) = middle;
  }
  return with;
}

void PairAdvance::decide() {
  const RigidMotion& motion = *law_.alone();
  const Triangle starting = triangle_of(placed(moving_, motion.start()));
  ++cost_.exact_tests;
  if (auto time = exact_sweep(starting, triangle_of(resting_), motion.by())) {
    goal_.add_exact(ids_, std::move(*time));
  }
}

void PairAdvance::decide_turn(double from, double until) {
  ++cost_.exact_tests;
  if (const auto time =
          exact_motion(*law_.alone(), triangle_of(moving_), triangle_of(resting_), from, until)) {
    goal_.add_spell(ids_, time->lower, time->upper);
    goal_.add_contact(ids_, time->upper);
  }
}

bool PairAdvance::pass(Place& place, const Parting& parting, double until) {
  if (bounds_.exact()) {
    decide();
    return false;
  }
  const double begin = place.t;
  const double enough = bounds_.pair_margin() + 2 * kNextToNone * bounds_.rounding();
  double before = begin;
  double length = first_look(place, parting.direction);
  const double soon = begin + kSoon * length;
  double t = begin;
  while (!touches(t)) {
    Place here = at(t);
    const bool apart = t > soon && parting_of(here.corners, resting_, enough).gap > enough;
    if (apart || t >= until) {
      if (bounds_.by_law()) {
        decide_turn(begin, until);
        return false;
      }
      const double simple = simplest(begin, t);
      const bool found = touches(simple);
      goal_.add_spell(ids_, begin, found ? simple : t);
      if (found) {
        goal_.add_contact(ids_, simple);
      }
      place = here;
      return !found && t < until;
    }
    before = t;
    t = std::min(until, begin + length);
    length *= 2;
  }
  const double contact = t > begin ? earliest(before, t) : t;
  goal_.add_spell(ids_, begin, contact);
  goal_.add_contact(ids_, contact);
  return false;
}

double PairAdvance::contact_ahead(double begin, double until) {
  double before = begin;
  for (double length = std::max(begin, 0x1p-30) * 0x1p-52; before < until; length *= 2) {
    const double t = std::min(until, begin + length);
    if (touches(t)) {
      return earliest(before, t);
    }
    before = t;
  }
  return std::numeric_limits<double>::infinity();
}

bool PairAdvance::advance(Place& place, double until, int steps) {
  const double enough = bounds_.pair_margin() + kNextToNone * bounds_.rounding();
  for (int k = 0; k < steps; ++k) {
    ++cost_.triangle_tests;
    if (place.t > goal_.limit()) {
      return true;
    }
    const Parting parting = parting_of(place.corners, resting_, enough);
    const bool apart = parting.gap > enough;
    if (apart && place.t >= until) {
      return true;
    }
    // A step to the end proves that there is no contact at the end either.
    if (apart && step(place, parting, until)) {
      if (place.t >= until) {
        return true;
      }
    } else if (!pass(place, parting, until)) {
      return true;
    }
  }
  return false;
}

void PairAdvance::run(double from, double until) {
  if (goal_.leaves_out(ids_)) {
    return;
  }
  curvature_ = law_.curvature(from, until).of(arm_);
  Place place = at(from);
  if (advance(place, until, kMostSteps)) {
    return;
  }
  if (bounds_.exact()) {
    decide();
  } else if (bounds_.by_law()) {
    decide_turn(place.t, until);
  } else {
    const double contact = contact_ahead(place.t, until);
    const bool found = contact <= until;
    if (found && advance(place, contact, kMoreSteps)) {
      return;
    }
    goal_.add_spell(ids_, place.t, found ? contact : until);
    if (found) {
      goal_.add_contact(ids_, contact);
    }
  }
}

}  // namespace soms::detail
