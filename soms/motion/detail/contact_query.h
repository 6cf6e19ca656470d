/// \file
/// The first contact of a body that follows a law with another: the answer for one motion.
#pragma once

#include "soms/base/limits.h"
#include "soms/motion/detail/motion_law.h"
#include "soms/motion/first_contact.h"

namespace soms::detail {

/// What is known of the bodies at 0 and at 1.
enum class EndsOfWay {
  unknown,
  free,  ///< their surfaces do not meet, by the decision for the poses of the law
};

/// \pre The poses passed their checks, and `options` too; no mesh is empty.
/// \errors As `first_contact`.
[[nodiscard]] FirstContact first_contact_by(const MotionLaw& law, const Shape& mover,
                                            const Shape& other, const FirstContactOptions& options,
                                            const Limits& limits,
                                            EndsOfWay ends = EndsOfWay::unknown);

}  // namespace soms::detail
