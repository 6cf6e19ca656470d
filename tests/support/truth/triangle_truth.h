/// \file
/// Do two triangles share a point? A twin of `triangles_overlap` that shares nothing with it: axes
/// that part them, in whole numbers of any length.
#pragma once

#include "soms/base/vector.h"

namespace soms::test {

/// The same meaning as `triangles_overlap`. \pre Coordinates are finite.
[[nodiscard]] bool share_a_point(const Triangle& s, const Triangle& t);

}  // namespace soms::test
