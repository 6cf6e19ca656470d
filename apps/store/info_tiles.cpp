#include "apps/store/info_tiles.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/output/json.h"
#include "apps/store/tiles.h"

#include <fmt/format.h>

namespace soms::command {

namespace {

void open_all(const std::string& folder, const Console& console) {
  const TileSet tiles = TileSet::open(folder, {.max_memory = 0, .check = TreeCheck::full});
  console.run("looking at the tiles of " + printable(folder), [&](const Parallel& parallel) {
    for (std::size_t k = 0; k < tiles.tiles().size(); ++k) {
      check_stop(parallel);
      static_cast<void>(tiles.open_tile(k));
      if (parallel.progress) {
        parallel.progress(static_cast<double>(k + 1) / static_cast<double>(tiles.tiles().size()));
      }
    }
    return 0;
  });
}

Json point_json(const Vec3& point) {
  return Json::array({point.x, point.y, point.z});
}

Json to_json(const std::string& folder, const TileSet& tiles) {
  Json sources = Json::array();
  for (const TileSource& source : tiles.manifest().sources) {
    sources.push_back(
        {{"file", source.file}, {"triangles", source.triangles}, {"first", source.first}});
  }
  Json json{{"schema", "soms.info/1"},        {"file", folder},
            {"triangles", tiles.triangles()}, {"tiles", tiles.tiles().size()},
            {"bytes", tiles.bytes()},         {"sources", sources}};
  const Box& box = tiles.bounds();
  json["bounds"] =
      box.empty() ? Json() : Json::array({point_json(box.lower), point_json(box.upper)});
  add_georeference(json, tiles.manifest().statements.georeference);
  return json;
}

std::string to_text(const std::string& folder, const TileSet& tiles) {
  std::string text = describe_tiles(folder, tiles) + "\n";
  const Box& box = tiles.bounds();
  if (!box.empty()) {
    text +=
        fmt::format("  bounds     {} to {}\n", point_in_text(box.lower), point_in_text(box.upper));
  }
  const Georeference& place = tiles.manifest().statements.georeference;
  if (!place.empty()) {
    text += fmt::format("  georeference {}\n", printable(describe(place)));
  }
  for (const TileSource& source : tiles.manifest().sources) {
    text += fmt::format("  model      {}: {}, numbered from {}\n", printable(source.file),
                        counted(source.triangles, "triangle"), source.first);
  }
  return text;
}

}  // namespace

void print_tiles(const std::string& folder, ModelOptions model, bool verify, Console& console) {
  model.allow_empty = true;
  const TileSet tiles = open_tiles(folder, model, {}, console);
  if (verify) {
    open_all(folder, console);
  }
  console.print(console.shared().json ? json_line(to_json(folder, tiles)) : to_text(folder, tiles));
  console.flush();
}

}  // namespace soms::command
