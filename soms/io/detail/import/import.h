/// \file
/// Formats that Assimp reads, by the program soms-import, which runs beside this one.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <span>
#include <string_view>

namespace soms::detail {

/// Extensions that are left to soms-import, sorted.
[[nodiscard]] std::span<const std::string_view> imported_extensions();

/// True if files with this extension, lower case and with its point, are left to soms-import.
[[nodiscard]] bool is_imported(std::string_view extension);

/// Reads a model by soms-import; what it answers is checked as a file is.
/// \errors ErrorKind::unsupported (the program is not installed), bad_file (also where the program
///         crashes or answers nonsense), timed_out, out_of_memory, empty_mesh, not_finite,
///         out_of_range, cancelled.
[[nodiscard]] Mesh read_import(Source& source);

}  // namespace soms::detail
