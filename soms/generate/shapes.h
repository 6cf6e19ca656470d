/// \file
/// Closed test bodies of an exact number of triangles.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms {

/// (2,3) torus knot of tube radius 0.4 scaled to reach 1; exactly `triangles`, at least 12 and
/// even. \errors  ErrorKind::usage naming the least and nearest possible count.
[[nodiscard]] Mesh generate_knot(std::uint64_t triangles);

/// UV sphere of radius 1 about the origin; exactly `triangles`, at least 8 and even.
/// \errors  ErrorKind::usage.
[[nodiscard]] Mesh generate_sphere(std::uint64_t triangles);

/// Kinds of movers that are generated.
enum class MoverKind { car, person, drone };

/// A mover in metres, z up, standing on z = 0 (drone: hovering about the origin), heading +x.
/// Closed. Exactly `triangles`; 0 gives the default count (car 1,000, person 600, drone 308).
/// \errors  ErrorKind::usage naming the least count.
[[nodiscard]] Mesh generate_mover(MoverKind kind, std::uint64_t triangles = 0);

}  // namespace soms
