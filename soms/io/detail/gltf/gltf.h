/// \file
/// glTF 2.0: text with its numbers in other files or in itself, and the binary form GLB.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/affine.h"
#include "soms/io/detail/source.h"
#include "soms/io/detail/tiles/batch_table.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace soms::detail {

namespace glb {

/// Bytes before the first chunk (a word, the version, the length of the file), and before what a
/// chunk holds (its length, its type).
inline constexpr std::size_t kHeader = 12;
inline constexpr std::size_t kChunkHeader = 8;

inline constexpr std::string_view kMagic = "glTF";
inline constexpr std::uint32_t kVersion = 2;
inline constexpr std::uint32_t kJson = 0x4e4f534a;    // "JSON"
inline constexpr std::uint32_t kBinary = 0x004e4942;  // "BIN"

}  // namespace glb

/// True if the bytes begin with the first word of GLB.
[[nodiscard]] bool is_glb(std::string_view bytes);

/// True if the text is a JSON object with the word "asset", which every glTF file has.
[[nodiscard]] bool is_gltf(std::string_view bytes);

/// The triangles of the default scene, node by node from the outside in, with the transforms of the
/// nodes applied in double. Nodes are parts. Axes and unit stay: y up, meters.
/// \errors ErrorKind::bad_file, unsupported (an extension that changes what is there, version 1),
///         cannot_open (a file that the model names), not_finite, out_of_range, empty_mesh,
///         out_of_memory, cancelled.
[[nodiscard]] Mesh read_gltf(Source& source);

/// The same of GLB. \errors As `read_gltf`.
[[nodiscard]] Mesh read_glb(Source& source);

/// What a tile of 3D Tiles says of the glTF in it.
struct GltfTile {
  Affine frame;        ///< from the axes of the tile to those of the mesh
  bool turned = true;  ///< the glTF is y up, as it should be, and has to be turned: tiles are z up
  const BatchTable* batches = nullptr;  ///< may be null
};

/// The same of glTF in a tile, text or binary, which is all of `source` from byte `begin` to `end`.
/// Of tiles, `CESIUM_RTC` is read too. Axes are those of the mesh of all tiles.
/// \errors As `read_gltf`.
[[nodiscard]] Mesh read_gltf_tile(Source& source, std::size_t begin, std::size_t end,
                                  const GltfTile& tile);

}  // namespace soms::detail
