/// \file
/// The first contact on a way that a box holds.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/motion/first_contact.h"

namespace soms::detail {

/// `first_contact` of a mover, all of whose way is in `box` (swept_bounds.h), with a body that
/// rests. Mostly no node of that one is near the box, or what is below those that are proves the
/// way to be free. So more may be proved free than by `first_contact`; other answers are its own.
/// \pre    The poses passed their checks; no mesh is empty.
/// \errors As `first_contact`.
[[nodiscard]] FirstContact first_contact_in_box(const Shape& mover, const RigidMotion& way,
                                                const Box& box, const Body& rests,
                                                const Limits& limits);

}  // namespace soms::detail
