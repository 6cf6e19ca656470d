/// \file
/// COLLADA: the scene of a digital asset exchange file, versions 1.4 and 1.5.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True if the first element is COLLADA.
[[nodiscard]] bool is_collada(std::string_view bytes);

/// Every triangle that the scene shows: geometries under the transforms of their nodes, each
/// instance again, in the order of the scene; named nodes are parts. A stated unit and up axis are
/// recorded in the mesh and not applied. Nothing outside the file is opened.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, unsupported, empty_mesh, out_of_memory,
///         cancelled.
[[nodiscard]] Mesh read_collada(Source& source);

}  // namespace soms::detail
