/// \file
/// The normal of a contact of two triangles, where there is one.
#pragma once

#include "soms/motion/detail/parting.h"

#include <optional>

namespace soms::detail {

/// The normal from y to x of two triangles that are in contact: a corner of one is within the face
/// of the other, or two edges cross. Nothing unless that is so for one pair of features only.
/// `reach` is how deep they may be in each other; `before` is x while it was apart.
[[nodiscard]] std::optional<Vec3> contact_normal(const Corners& x, const Corners& y, double reach,
                                                 const Corners& before);

}  // namespace soms::detail
