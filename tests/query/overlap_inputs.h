/// \file
/// Inputs that try queries of bodies: meshes of every awkward kind, poses of every allowed one.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"
#include "soms/query/body.h"
#include "soms/tree/build_options.h"

namespace soms::test {

/// A mesh of up to `most` triangles: soup, ball, plane, line, point, copies, or slivers.
[[nodiscard]] Mesh awkward_mesh(Rng& rng, int most);

/// The mesh with every vertex multiplied by `scale`, then shifted by `shift`.
[[nodiscard]] Mesh placed(Mesh mesh, double scale, const Vec3& shift);

/// The mesh closed: each triangle with the three that join its edges to `apex`.
[[nodiscard]] Mesh coned(Mesh mesh, const Vec3& apex);

/// A rotation: the identity, a quarter turn, or any, sometimes off orthonormal by up to 9e-7.
[[nodiscard]] Pose awkward_rotation(Rng& rng);

/// `rotation` with the shift that moves point `p` to `q`.
[[nodiscard]] Pose moving(const Pose& rotation, const Vec3& p, const Vec3& q);

/// Any rule, with leaves of 1, 4, 8 or 1000.
[[nodiscard]] BuildOptions awkward_options(Rng& rng);

/// Two bodies that are likely to meet.
struct Two {
  Body a;
  Body b;
};

/// Awkward meshes of up to `most` triangles, scaled, at most `far` from the origin, by any rule at
/// awkward poses that bring a vertex of each together, or nearly.
[[nodiscard]] Two likely_to_meet(Rng& rng, int most, double scale_a, double scale_b, double far);

/// A point drawn evenly from a box.
[[nodiscard]] Vec3 point_in(Rng& rng, const Box& box);

}  // namespace soms::test
