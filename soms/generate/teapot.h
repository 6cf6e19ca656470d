/// \file
/// The teapot of computer graphics.
#pragma once

#include "soms/geometry/mesh.h"

#include <cstdint>

namespace soms {

/// Fewest subdivisions of a teapot's patches: with 1 the end of the spout would be a line.
inline constexpr std::uint32_t kLeastTeapotSubdivisions = 2;

/// Most subdivisions of a teapot's patches.
inline constexpr std::uint32_t kMostTeapotSubdivisions = 256;

/// Triangles of a teapot: two for each cell of its 32 patches, less those that have no area because
/// four patches meet at the knob and four at the middle of the bottom.
[[nodiscard]] constexpr std::uint64_t teapot_triangles(std::uint32_t subdivisions) {
  const std::uint64_t n = subdivisions;
  return 64 * n * n - 8 * n;
}

/// Newell's teapot: each of its 32 bicubic Bezier patches cut into `subdivisions` by `subdivisions`
/// cells (10: 6,320 triangles). z up, standing on z = 0, spout toward +x, 3.15 high; faces look
/// outward. Parts rim, body, lid, bottom, handle, spout: each point is one vertex, but handle and
/// spout end inside the body, the lid lies loose on the rim, and nothing is thick: not closed. The
/// same bits on every machine.
///
/// \errors  ErrorKind::usage unless kLeastTeapotSubdivisions to kMostTeapotSubdivisions.
/// \source  Newell 1975, The utilization of procedure models in digital image synthesis,
///          dissertation, University of Utah; control points as published by Crow 1987, The origins
///          of the teapot, IEEE Computer Graphics and Applications 7(1), with the bottom that was
///          added later.
[[nodiscard]] Mesh generate_teapot(std::uint32_t subdivisions = 10);

}  // namespace soms
