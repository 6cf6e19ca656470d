/// \file
/// Bodies of every size that doubles have, whose triangles are of very different sizes.
#pragma once

#include "soms/base/pose.h"
#include "soms/base/random.h"
#include "soms/geometry/mesh.h"

#include <cstddef>

namespace soms::test {

/// Powers of two: of a body's size, and of that of its least triangles.
struct Scales {
  int body = 0;
  int triangle = 0;
};

/// All bodies from 2^-1070 to 2^300, each power next to those that trees take as they are and where
/// units change or squares and products of three underflow in floats or doubles, with triangles
/// from 2^0 to 2^-60 of them: so many cases, and the one of a number.
[[nodiscard]] std::size_t count_of_scales();
[[nodiscard]] Scales scales_of(std::size_t number);

/// Any of these.
[[nodiscard]] Scales any_scales(Rng& rng);

/// A few triangles as large as the body, and heaps of small ones on each other: sheets, a lattice,
/// a soup, or points. Coordinates are within 2^body.
[[nodiscard]] Mesh uneven_mesh(Rng& rng, const Scales& scales);

/// The same of closed surfaces: tetrahedra, which may cross each other.
[[nodiscard]] Mesh uneven_solids(Rng& rng, const Scales& scales);

/// A mesh to be beside another one of these scales, as it is and moved by nothing: heaps of small
/// triangles, or tetrahedra, at small triangles of the other or a little off, and now and then some
/// as large as the body; or a single point.
[[nodiscard]] Mesh uneven_beside(Rng& rng, const Scales& scales, const MeshView& other,
                                 bool solids);

/// A pose that keeps such a mesh within 2^300: any rotation, and no shift, one of the size of a
/// least triangle, one of the size of the body, or one so far that all of it moves to a few places.
[[nodiscard]] Pose pose_at(Rng& rng, const Scales& scales);

/// A triangle of a mesh, mostly a small one, and a point of it as near as doubles allow: of a
/// corner, an edge or a face.
[[nodiscard]] Vec3 point_of_small(Rng& rng, const MeshView& mesh, const Pose& pose);

/// A vector of any direction, at times along an axis, and of about this length.
[[nodiscard]] Vec3 any_way(Rng& rng, double length);

}  // namespace soms::test
