/// \file
/// Do two triangles share a point? Decided exactly.
#pragma once

#include "soms/base/vector.h"

#include <cstdint>

namespace soms {

/// True if two closed triangles share at least one point: crossing, touching at a corner, an edge
/// or a face, or coplanar with common area. A triangle without area is the segment or point it is.
/// Symmetric, and independent of the order of corners.
///
/// \pre     Coordinates are finite and of magnitude at most 2^300.
/// \errors  None but memory.
/// \cost    About 100 ns; touching and coplanar pairs take exact arithmetic. `exact_tests`, when
///          given, is increased by one if a sign needed exact arithmetic.
/// \source  Guigue and Devillers 2003 for general position; dimension-first dispatch of degenerate
///          triangles is our own.
[[nodiscard]] bool triangles_overlap(const Triangle& s, const Triangle& t,
                                     std::uint64_t* exact_tests = nullptr);

}  // namespace soms
