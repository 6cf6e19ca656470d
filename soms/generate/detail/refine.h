/// \file
/// More triangles for a closed mesh, one exact step at a time.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms::detail {

/// Halves the longest edge again and again until the mesh has `triangles` triangles: each step cuts
/// the two triangles beside the edge in two. The surface keeps its shape and stays closed; parts
/// stay contiguous. Ties are broken by the lower vertex numbers.
///
/// \pre     Closed and two-manifold by vertex index, in each part; `triangles` is at least the
///          present count and differs from it by an even number.
/// \cost    O(n log n).
void refine(Mesh& mesh, std::uint64_t triangles);

}  // namespace soms::detail
