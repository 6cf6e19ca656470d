/// \file
/// Tilesets of 3D Tiles 1.0 and 1.1: the tree of tiles, of which the finest are read.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"

#include <string_view>

namespace soms::detail {

/// True for a JSON object that has "asset", and "root" or "geometricError", and nothing of glTF.
[[nodiscard]] bool is_tileset(std::string_view bytes);

/// The triangles of the finest tiles, each content with its batches in a part that is named as its
/// file. Axes are those of the root: its tiles' transforms are applied in double.
/// \errors As `read_mesh`: bad_file names the place in the JSON (`root.children[0].transform`),
///         cannot_open the file that is missing, unsupported what is not read (implicit tiling).
/// \source OGC 18-053r2, 3D Tiles 1.0; OGC 22-025r4, 3D Tiles 1.1
[[nodiscard]] Mesh read_tileset(Source& source);

}  // namespace soms::detail
