/// \file
/// `motion --verify`: is an answer what brute force allows?
#pragma once

#include "soms/motion/first_contact.h"

#include <optional>
#include <string>

namespace soms::command {

/// A motion that was answered: of A past B, on a way of its own. Where B rests, that is a shift by
/// nothing.
struct VerifiedMotion {
  Shape a;
  RigidMotion way_of_a;
  Shape b;
  RigidMotion way_of_b;
};

/// What brute force finds wrong with an answer; nothing if it finds the same. All pairs of
/// triangles are compared at 33 times of the way. If B rests and there are few pairs, the law of
/// the motion decides all of them in whole numbers, for all times.
/// \errors ErrorKind::cancelled, timed_out.
[[nodiscard]] std::optional<std::string> motion_difference(const VerifiedMotion& motion,
                                                           const FirstContact& answer,
                                                           const FirstContactOptions& options,
                                                           const Limits& limits);

}  // namespace soms::command
