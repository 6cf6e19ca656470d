/// \file
/// Tiles of a tileset as its JSON states them: where they stand, what they hold.
#pragma once

#include "soms/io/detail/affine.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/tiles/tile_volume.h"

#include <optional>
#include <vector>

namespace soms::detail {

/// What becomes of a tile where its children are shown.
enum class Refinement { replace, add };

/// A content of a tile.
struct TileContent {
  JsonValue uri;
  std::optional<TileVolume> volume;  ///< of the content, or else of its tile
};

/// A tile, checked.
struct Tile {
  JsonValue json;
  Affine frame;  ///< from its axes to those of the root
  Refinement refinement = Refinement::replace;
  std::vector<TileContent> contents = {};
  std::optional<JsonValue> children = {};
};

/// Checks what a tileset states about itself: its version, the extensions that it needs.
/// \errors ErrorKind::bad_file, unsupported.
void check_tileset(const JsonValue& root);

/// True if glTF in the tileset is y up, as it should be; false for the older "gltfUpAxis": "Z".
/// \errors ErrorKind::unsupported: another axis.
[[nodiscard]] bool contents_are_y_up(const JsonValue& root);

/// The tile of this JSON; `around` is the frame of the tile that it is within, `refinement` that
/// tile's. \errors ErrorKind::bad_file, unsupported (implicit tiling).
[[nodiscard]] Tile tile_of(const JsonValue& json, const Affine& around, Refinement refinement);

/// True if a tile below this one has a content.
[[nodiscard]] bool has_content_below(const JsonValue& tile);

}  // namespace soms::detail
