/// \file
/// A closed body whose triangles are as unlike as those of a simplified scan.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms {

/// A bust on a plinth, exactly `triangles`, at least 8 and even: one closed surface, grown from an
/// octahedron by cutting long edges in two, more often about the face, with the unevenness of a
/// scan. z up, 1 high, standing on z = 0, facing -y. The same bits on every machine.
/// \errors  ErrorKind::usage naming the least and nearest possible count.
/// \cost    O(n log n); about 100 bytes a triangle.
[[nodiscard]] Mesh generate_statue(std::uint64_t triangles);

}  // namespace soms
