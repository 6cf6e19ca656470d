/// \file
/// The brute-force twin of `self_overlap`: every pair of triangles, no tree, exact signs.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/query/self_overlap.h"

namespace soms::reference {

/// All pairs by a linear scan; `cost` counts nothing. The same meaning as `soms::self_overlap`.
/// \cost O(n^2) box tests.
[[nodiscard]] SelfOverlap self_overlap(const MeshView& mesh,
                                       CommonCorners by = CommonCorners::index,
                                       const Limits& limits = {});

}  // namespace soms::reference
