/// \file
/// `tiles.json`: which tiles a folder has.
#pragma once

#include "soms/tiles/tile_set.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace soms::detail {

/// The manifest as JSON. Equal manifests give equal bytes.
[[nodiscard]] std::string manifest_text(const TileManifest& manifest);

/// Reads it back, but for the statements of the mesh beyond unit, up axis and reference system.
/// \errors ErrorKind::bad_file, which names the entry; unsupported for another version.
[[nodiscard]] TileManifest parse_manifest(std::string_view text, const std::string& name);

/// Writes a file that appears whole or not at all. \errors ErrorKind::cannot_write.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

/// `lanes_hash` of all that a manifest says but the names of sources.
[[nodiscard]] std::uint64_t content_hash(TileManifest manifest);

/// 16 digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace soms::detail
