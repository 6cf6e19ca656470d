/// \file
/// Folders of tiles named on the command line in place of a model.
#pragma once

#include "soms/tiles/tile_set.h"
#include "soms/tree/build_options.h"

#include "apps/model/models.h"
#include "apps/output/json.h"

#include <string>
#include <string_view>
#include <vector>

namespace soms::command {

class Console;

/// An option that was given, and why it has no meaning beside tiles.
struct RefusedOfTiles {
  bool given = false;
  std::string option;
  std::string_view reason;
};

/// --verify, for `refuse_of_tiles`.
[[nodiscard]] inline RefusedOfTiles refused_verify(bool given) {
  return {given, "--verify", "brute force needs the whole model"};
}

/// --only and --ignore, likewise.
[[nodiscard]] RefusedOfTiles refused_parts(const ModelOptions& model);

/// \errors ErrorKind::usage for what was given.
void refuse_of_tiles(const std::string& folder, const std::vector<RefusedOfTiles>& refused);

/// Opens a folder of tiles, of which options end in `suffix` ("-b"). --max-memory is the most bytes
/// of tiles that are mapped at a time. \errors As `TileSet::open`; ErrorKind::usage for options
/// that would change triangles or trees;
///         empty_mesh without triangles.
[[nodiscard]] TileSet open_tiles(const std::string& folder, const ModelOptions& model,
                                 const BuildOptions& build, const Console& console,
                                 std::string_view suffix = {});

/// "city: 3,000,000 triangles in 4 tiles, 342 MB".
[[nodiscard]] std::string describe_tiles(const std::string& folder, const TileSet& tiles);

/// The models of tiles, for JSON.
[[nodiscard]] Json sources_json(const TileSet& tiles);

}  // namespace soms::command
