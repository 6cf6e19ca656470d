/// \file
/// Lengths and directions of vectors of any size.
#pragma once

#include "soms/base/vector.h"

namespace soms::detail {

/// The largest magnitude of a coordinate.
[[nodiscard]] double largest(const Vec3& v);

/// The length of a finite vector, to a few roundings; nothing over- or underflows on the way.
[[nodiscard]] double length(const Vec3& v);

/// The direction of `v`, of length 1 to a few roundings; any where it is 0.
[[nodiscard]] Vec3 direction(const Vec3& v);

}  // namespace soms::detail
