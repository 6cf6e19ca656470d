/// \file
/// STL: binary and ascii.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True if the size is exactly what the count of a binary file says, or if the text begins with the
/// word solid.
[[nodiscard]] bool is_stl(std::string_view bytes);

/// Three vertices a triangle: none are joined. Solids are parts.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, empty_mesh, out_of_memory, cancelled.
[[nodiscard]] Mesh read_stl(Source& source);

}  // namespace soms::detail
