/// \file
/// 3DS: the objects of an Autodesk 3D Studio file.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True if the first chunk is the main chunk of 3DS and as long as the file.
[[nodiscard]] bool is_three_ds(std::string_view bytes);

/// Every triangle of every object in the order of the file; objects are parts. Vertices are taken
/// as stored, which is where they stand in the world; a master scale and keyframes are noted in the
/// mesh and not applied.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, empty_mesh, out_of_memory, cancelled.
[[nodiscard]] Mesh read_three_ds(Source& source);

}  // namespace soms::detail
