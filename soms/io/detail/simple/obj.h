/// \file
/// OBJ: the polygons of a Wavefront file.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True if the first word that is no comment is one with which OBJ files begin.
[[nodiscard]] bool is_obj(std::string_view bytes);

/// Vertices and faces; objects and groups are parts, named by the last o or g line. Materials,
/// normals and texture coordinates are passed; lines, points and free-form surfaces are noted in
/// the mesh. A face may name vertices that stand behind it.
/// \errors ErrorKind::bad_file, not_finite, out_of_range, empty_mesh, out_of_memory, cancelled.
[[nodiscard]] Mesh read_obj(Source& source);

}  // namespace soms::detail
