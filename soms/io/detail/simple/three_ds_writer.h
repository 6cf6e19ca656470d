/// \file
/// Writing 3DS: a mesh cut into objects that the format has room for.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/io/detail/output.h"

#include <cstdint>
#include <string>

namespace soms::detail {

/// Writes the chunks of a 3DS file: an object for each run of triangles of one part, and another
/// wherever 65,535 vertices or faces are full. An object holds the vertices that its triangles use,
/// in the order of the mesh. \pre `check` passes the mesh.
/// \errors ErrorKind::out_of_range, cancelled.
void write_three_ds(Output& output, const std::string& name, const MeshView& mesh,
                    const Limits& limits);

/// Named parts whose objects `write_three_ds` names otherwise: names are cut, made ASCII and made
/// different from one another. \errors ErrorKind::out_of_range.
[[nodiscard]] std::uint64_t renamed_in_three_ds(const MeshView& mesh);

}  // namespace soms::detail
