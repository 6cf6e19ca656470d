#include "apps/store/tiles.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/part_filter.h"

#include <fmt/format.h>

namespace soms::command {

RefusedOfTiles refused_parts(const ModelOptions& model) {
  const bool given = model.parts && model.parts->is_given();
  return {given, given ? model.parts->options() : std::string(),
          "a part may lie in several of them"};
}

void refuse_of_tiles(const std::string& folder, const std::vector<RefusedOfTiles>& refused) {
  for (const auto& [given, option, reason] : refused) {
    if (given) {
      throw Error(
          ErrorKind::usage,
          fmt::format("{}: {} does not go with tiles: {}", printable(folder), option, reason),
          "leave it out, or give a model");
    }
  }
}

TileSet open_tiles(const std::string& folder, const ModelOptions& model, const BuildOptions& build,
                   const Console& console, std::string_view suffix) {
  constexpr std::string_view kCut = "triangles were cut as they are, and soms tile takes it";
  const auto of = [&](std::string_view option) { return fmt::format("{}{}", option, suffix); };
  refuse_of_tiles(folder,
                  {{model.scale != 1, of("--scale"), kCut},
                   {model.up != UpAxis::unknown, of("--up"), kCut},
                   {!model.crs.empty(), of("--crs"), kCut},
                   {model.lod.has_value(), "--lod", kCut},
                   {model.surfaces, "--surfaces", kCut},
                   refused_parts(model),
                   {build != BuildOptions(), "--tree", "trees are built, and soms tile takes it"}});
  TileOptions options;
  if (console.shared().max_memory != 0) {
    options.max_memory = console.shared().max_memory;
  }
  TileSet tiles = TileSet::open(folder, options);
  if (tiles.triangles() == 0 && !model.allow_empty) {
    throw Error(ErrorKind::empty_mesh, printable(folder) + ": no triangles",
                model.offers_empty ? "give --allow-empty to accept that" : "give another model");
  }
  return tiles;
}

std::string describe_tiles(const std::string& folder, const TileSet& tiles) {
  return fmt::format("{}: {} in {}, {}", printable(folder), counted(tiles.triangles(), "triangle"),
                     counted(tiles.tiles().size(), "tile"), readable_bytes(tiles.bytes()));
}

Json sources_json(const TileSet& tiles) {
  Json sources = Json::array();
  for (const TileSource& source : tiles.manifest().sources) {
    sources.push_back(
        {{"file", source.file}, {"triangles", source.triangles}, {"first", source.first}});
  }
  return sources;
}

}  // namespace soms::command
