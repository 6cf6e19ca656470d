/// \file
/// Writing GLB: the binary form of glTF 2.0.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/io/detail/output.h"

#include <string>

namespace soms::detail {

/// What is taken off every vertex of a GLB file, and put back by its nodes: nothing where all
/// vertices are floats; else the middle of the mesh, with few bits, so that floats far from the
/// origin keep more of each vertex.
[[nodiscard]] Vec3 glb_origin(const MeshView& mesh);

/// What is read back for a vertex of a mesh with this origin, if a float can hold it.
[[nodiscard]] Vec3 glb_read_back(const Vec3& vertex, const Vec3& origin);

/// Writes a node for each part, or for each run of triangles of one part where parts do not nest as
/// the triangles do. Triangles keep their order; parts that share no vertices keep all of theirs,
/// and others have the vertices that their triangles use. \pre `check` passes the mesh.
/// \errors ErrorKind::not_finite, out_of_range, cancelled.
void write_glb(Output& output, const std::string& name, const MeshView& mesh, const Limits& limits);

}  // namespace soms::detail
