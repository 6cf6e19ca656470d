/// \file
/// The first contact of two triangles, one of which moves: conservative advancement by chords.
#pragma once

#include "soms/motion/detail/contact_goal.h"
#include "soms/motion/detail/motion_bounds.h"
#include "soms/motion/detail/parting.h"
#include "soms/query/answer.h"

#include <cstdint>

namespace soms::detail {

/// Follows one pair of triangles through a window of times. A step goes as far as the speed along
/// the parting direction lets it; that is a guess. What proves the step is the chord of
/// motion_bounds.h: the gaps at both ends, less what the curve may leave the chord by.
class PairAdvance {
 public:
  /// `resting` is in the frame of the law.
  PairAdvance(const MotionBounds& bounds, const Shape& mover, const Body& resting,
              const TrianglePair& ids, ContactGoal& goal, Cost& cost);

  /// Adds to the goal what is not free in [from, until]. \pre 0 <= from <= until <= 1
  void run(double from, double until);

 private:
  /// The triangle at a time.
  struct Place {
    double t = 0;
    Corners corners;
  };

  [[nodiscard]] Place at(double t) const;

  /// By the poses that are decided.
  [[nodiscard]] bool touches(double t);

  /// About how the corners move.
  [[nodiscard]] Corners velocities(const Place& place) const;

  /// How long after `place` a contact is looked for first, where `n` parted the triangles.
  [[nodiscard]] double first_look(const Place& place, const Vec3& n) const;

  /// About how far to go from `place` until the gap along a direction is spent.
  [[nodiscard]] double reach(const Place& place, const Parting& parting) const;

  /// Goes on from `place` to a later time, up to `until`, with a proof; false if it cannot.
  [[nodiscard]] bool step(Place& place, const Parting& parting, double until) const;

  /// Decides a straight motion in whole numbers, whatever was proved before.
  void decide();

  /// Decides a motion with a turn from `from` on, by its law in whole numbers.
  void decide_turn(double from, double until);

  /// By looking ever farther ahead from `begin`, where steps were spent; infinity if there is none.
  [[nodiscard]] double contact_ahead(double begin, double until);

  /// Goes on from `place` by so many steps at most; true if all is decided until then.
  [[nodiscard]] bool advance(Place& place, double until, int steps);

  /// From `place` on nothing can be proved free: looks for a pose in contact, until the time when
  /// there is a gap again. If none is found, the law decides all the rest where it can; else true
  /// if steps go on from there.
  [[nodiscard]] bool pass(Place& place, const Parting& parting, double until);

  /// Draws a proved contact nearer to a time without one.
  [[nodiscard]] double earliest(double without, double with);

  const MotionBounds& bounds_;
  const MotionLaw& law_;
  TrianglePair ids_;
  Corners moving_;  ///< in the coordinates of its body
  Corners other_;   ///< likewise
  Corners resting_;
  double arm_ = 0;
  double curvature_ = 0;  ///< of all corners, over what is left
  ContactGoal& goal_;
  Cost& cost_;
};

}  // namespace soms::detail
