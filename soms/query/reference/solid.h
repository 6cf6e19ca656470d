/// \file
/// The brute-force twin of `solid`: every triangle against every other, no tree. What tests and
/// `--verify` believe.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/solid.h"

namespace soms::reference {

/// Same meaning as `soms::solid` of closed bodies, without its short cuts: each triangle of either
/// body is cut by all that overlap it, whether it touches the other body or not, and beside each
/// cell all triangles decide which body is where, by rays along another axis than `solid` takes.
/// What it shares with `solid` is the arithmetic of cells (plane_cells.h). Whether the bodies are
/// closed is not checked. Of `limits` only `stop` counts.
/// \errors As for a query of the meshes at their poses; ErrorKind::cancelled.
/// \cost O(n^2) tests of overlap, and O(n) for each cell.
[[nodiscard]] Solid solid_by_brute_force(const Body& a, const Body& b, const Limits& limits = {});

}  // namespace soms::reference
