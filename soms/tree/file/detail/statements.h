/// \file
/// What a mesh states beside its arrays, as bytes of a tree file: parts, unit, source, notes.
#pragma once

#include "soms/geometry/mesh.h"

#include <string>
#include <string_view>

namespace soms::detail {

[[nodiscard]] std::string bytes_of_statements(const MeshView& mesh);

/// A mesh that has the statements, and no arrays.
/// \errors ErrorKind::bad_file; `name` is the file's.
[[nodiscard]] Mesh read_statements(std::string_view bytes, const std::string& name);

}  // namespace soms::detail
