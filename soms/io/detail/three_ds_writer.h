/// \file
/// Writing 3DS: a mesh cut into objects that the format has room for.
#pragma once

#include "soms/base/parallel.h"
#include "soms/geometry/mesh.h"
#include "soms/io/detail/output.h"

#include <string>

namespace soms::detail {

/// Writes the chunks of a 3DS file: an object for each run of triangles of one part, and another
/// wherever 65,535 vertices or faces are full. An object holds the vertices that its triangles use,
/// in the order of the mesh. \pre `check` passes the mesh.
/// \errors ErrorKind::out_of_range, cancelled.
void write_three_ds(Output& output, const std::string& name, const Mesh& mesh,
                    const Parallel& parallel);

}  // namespace soms::detail
