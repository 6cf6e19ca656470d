/// \file
/// Meshes that change their form: the same triangles, moved vertices, the same tree with new boxes.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/shape.h"
#include "soms/tree/tree.h"

#include <memory>
#include <vector>

namespace soms {

/// The same nodes over a mesh with the same triangles and moved vertices. Each box is again exactly
/// the bounds of its triangles, so `find_fault` finds none. The same for any number of threads.
///
/// \pre     `tree` is whole for a mesh of these triangles.
/// \errors  As `check(Mesh)`; ErrorKind::usage for another number of triangles; cancelled.
/// \cost    O(n) time.
[[nodiscard]] Tree refit(const Tree& tree, const MeshView& mesh, const Limits& limits = {});

/// A shape whose vertices were moved: its layout, and its tree where it was kept, are those of
/// `shape` with new boxes. Queries answer exactly as on a shape that is rebuilt. The shape that
/// is passed stays as it is; copies of it are not moved.
///
/// The result's `sah_degradation` compares it with the last build, over any number of refits.
///
/// \errors  As `check(Mesh)`, not_finite above all; ErrorKind::usage for another number of
///          vertices or other triangles; cancelled.
/// \cost    O(n) time, half of a build's; a new mesh and layout are allocated.
[[nodiscard]] Shape refit(const Shape& shape, std::shared_ptr<const Mesh> mesh,
                          const Limits& limits = {});

/// The same, with a copy of the shape's mesh but for its vertices.
[[nodiscard]] Shape refit(const Shape& shape, std::vector<Vec3> vertices,
                          const Limits& limits = {});

/// SAH degradation from which on a new build pays soon; docs/refit.md says what was measured.
inline constexpr double kMostSahDegradation = 1.2;

/// True when the shape is so far from the form it was built for that a build is due.
[[nodiscard]] inline bool build_is_due(const Shape& shape) {
  return shape.sah_degradation() > kMostSahDegradation;
}

}  // namespace soms
