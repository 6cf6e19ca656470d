/// \file
/// Batched models of 3D Tiles (b3dm): binary glTF with a table of its objects.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/source.h"
#include "soms/io/detail/tiles/tile_content.h"

#include <cstddef>

namespace soms::detail {

/// What to do about a tile that is damaged.
inline constexpr const char* kRepairTile = "get the complete file, or repair it";

/// The bytes that the header of a tile states; a header of `least` bytes is complete.
/// \errors ErrorKind::bad_file, unsupported (a version other than 1).
[[nodiscard]] std::size_t tile_size(const Source& source, std::size_t begin, std::size_t end,
                                    std::size_t least);

/// The batched model from byte `begin` to `end` of a file: its batches are parts.
/// \errors As `read_tile_content`.
[[nodiscard]] Mesh read_b3dm(Source& source, std::size_t begin, std::size_t end,
                             const TileFrame& frame);

}  // namespace soms::detail
