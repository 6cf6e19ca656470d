/// \file
/// The brute-force twin of `clearance_along`: many places of the motion, each by brute force, and
/// rotations by angles. What tests and `--verify` believe.
#pragma once

#include "soms/scene/clearance_along.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace soms::reference {

/// The pose at a part of a segment, as `pose_at` but for rounding: by the angle of the turn, with
/// the sines of the C library.
[[nodiscard]] Pose pose_by_angle(const MotionPath& path, std::size_t segment, double t);

/// How near `mover` is at a pose to the nearest of `fixed`, as a station has it.
[[nodiscard]] ClearanceStation clearance_by_brute_force(const Shape& mover, const Pose& pose,
                                                        std::span<const Body> fixed,
                                                        const Limits& limits = {});

/// What brute force says of an answer.
struct ClearanceCheck {
  std::uint64_t places = 0;  ///< that were queried
  std::uint64_t wrong = 0;   ///< where the answer is refuted
  std::string first = {};    ///< of these, in words
};

/// Compares each station, each place of a least gap and the first contact of an answer with brute
/// force, bit by bit; and bounds of each stretch with `samples` places between its stations, evenly
/// spread: none is nearer than `at_least`, none is on the wrong side of the clearance where the
/// answer says that all or none are, and none before the first contact touches.
/// \cost  O(n m) for each place.
[[nodiscard]] ClearanceCheck check_clearance(const Clearance& answer, const Shape& mover,
                                             const MotionPath& path, std::span<const Body> fixed,
                                             const ClearanceOptions& options, std::size_t samples,
                                             const Limits& limits = {});

}  // namespace soms::reference
