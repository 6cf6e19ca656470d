/// \file
/// The formats that are written, onto any output.
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/io/detail/output.h"
#include "soms/io/write_mesh.h"

#include <string>

namespace soms::detail {

/// Writes a mesh and flushes; the same bytes for the same mesh. `name` is used in messages.
/// \errors What `check` says of the mesh; ErrorKind::not_finite, out_of_range, cancelled.
void write_mesh(Output& output, const std::string& name, const MeshView& mesh, MeshFormat format,
                const Limits& limits);

}  // namespace soms::detail
