/// \file
/// The brute-force twin of `overlap`: every pair of triangles, no tree. What tests and `--verify`
/// believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/query/overlap.h"

#include <span>
#include <vector>

namespace soms::reference {

/// All pairs of overlapping triangles by a linear scan with a closed box reject. Same meaning as
/// `soms::overlap`, sorted; `cost.node_tests` counts box rejects tried.
/// \cost    O(n m) box tests at worst; the boxes of `b` are swept once for each triangle of `a`.
[[nodiscard]] Overlap overlap(const MeshView& a, const Pose& pose_a, const MeshView& b,
                              const Pose& pose_b, const Limits& limits = {});

}  // namespace soms::reference
