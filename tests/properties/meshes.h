/// \file
/// Meshes that properties are checked on.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include <rapidcheck.h>

#include <cstdint>
#include <vector>

namespace soms::test {

/// Corners of a lattice of 9 x 9 x 9 points, three for a triangle: touching, coplanar, doubled and
/// degenerate triangles abound, and shrinking leaves the few that matter.
using Corners = std::vector<std::uint16_t>;

[[nodiscard]] rc::Gen<Corners> lattice_corners();

/// The triangles, with `unit` between neighboring points.
[[nodiscard]] Mesh lattice_mesh(const Corners& corners, double unit);

/// Any rotation, and a shift of up to `reach` along each axis.
[[nodiscard]] Pose any_pose(Rng& rng, double reach);

struct TwoMeshes {
  Mesh a;
  Mesh b;
};

/// Kinds of `meshes_of_kind`.
inline constexpr int kBodyKinds = 8;

/// The kinds whose meshes touch where they are.
[[nodiscard]] constexpr bool touches_in_place(int kind) {
  return kind == 1 || kind == 2;
}

/// The kind that is 2^-70 small.
[[nodiscard]] constexpr bool is_tiny(int kind) {
  return kind == 4;
}

/// Meshes of one kind: random, touching, nested, flat, tiny, far, on a line, and random beside a
/// line. The second may be empty.
[[nodiscard]] TwoMeshes meshes_of_kind(int kind, Rng& rng);

/// The four faces of each of up to `most` tetrahedra, flat ones too, on a lattice or anywhere:
/// closed as a whole, however they cross. Some triangles are turned over, doubled, or without area.
[[nodiscard]] Mesh closed_mesh(Rng& rng, std::uint64_t most = 8);

/// A closed mesh, as above or round, of any size and anywhere.
[[nodiscard]] Mesh any_closed_mesh(Rng& rng);

}  // namespace soms::test
