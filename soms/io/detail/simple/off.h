/// \file
/// OFF: text, with or without colors, normals and texture coordinates.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True if the first word is a magic word of OFF.
[[nodiscard]] bool is_off(std::string_view bytes);

/// \errors ErrorKind::bad_file, not_finite, out_of_range, unsupported (binary or four-dimensional
/// OFF), empty_mesh, out_of_memory, cancelled.
[[nodiscard]] Mesh read_off(Source& source);

}  // namespace soms::detail
