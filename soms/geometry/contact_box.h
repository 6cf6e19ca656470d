/// \file
/// The box around what the triangles of two surfaces have in common.
#pragma once

#include "soms/base/box.h"
#include "soms/base/vector.h"

#include <cstdint>

namespace soms {

/// Grows `box`, which lies around the points that the first `count` pairs of triangles of a row
/// share, by one more pair. Every shared point is in it. Tight while `count` is small; afterwards
/// by the boxes of the triangles, which costs a hundredth.
void grow_by_contact(Box& box, std::uint64_t count, const Triangle& a, const Triangle& b);

}  // namespace soms
