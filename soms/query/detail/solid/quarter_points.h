/// \file
/// Points to look at where two triangles cross.
#pragma once

#include "soms/base/vector.h"

#include <array>
#include <optional>

namespace soms::detail {

/// Two planes part space into four quarters: a point in each, near the middle of the segment in
/// which two triangles cross. Plain doubles, and nothing where they find no such segment: what the
/// points are worth has to be decided by whoever uses them.
[[nodiscard]] std::optional<std::array<Vec3, 4>> quarter_points(const Triangle& s,
                                                                const Triangle& t);

}  // namespace soms::detail
