#include "apps/store/info_tiles.h"

#include "apps/cli/console.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/output/json.h"
#include "apps/store/tiles.h"

#include <fmt/format.h>

#include <string>

namespace soms::command {

namespace {

Json point_json(const Vec3& point) {
  return Json::array({point.x, point.y, point.z});
}

char axis_of(UpAxis up) {
  return static_cast<char>('x' + (static_cast<int>(up) - static_cast<int>(UpAxis::x)));
}

Json to_json(const std::string& folder, const TileSet& tiles) {
  Json json{{"schema", "soms.info/1"},        {"file", folder},
            {"triangles", tiles.triangles()}, {"tiles", tiles.tiles().size()},
            {"bytes", tiles.bytes()},         {"sources", sources_json(tiles)}};
  const Box& box = tiles.bounds();
  json["bounds"] =
      box.empty() ? Json() : Json::array({point_json(box.lower), point_json(box.upper)});
  const Mesh& statements = tiles.manifest().statements;
  json["unit"] = statements.unit == 0 ? Json() : Json(statements.unit);
  json["up"] =
      statements.up == UpAxis::unknown ? Json() : Json(std::string(1, axis_of(statements.up)));
  add_georeference(json, statements.georeference);
  return json;
}

std::string to_text(const std::string& folder, const TileSet& tiles, bool verified) {
  std::string text = describe_tiles(folder, tiles) + "\n";
  const Box& box = tiles.bounds();
  if (!box.empty()) {
    text +=
        fmt::format("  bounds     {} to {}\n", point_in_text(box.lower), point_in_text(box.upper));
  }
  const Mesh& statements = tiles.manifest().statements;
  if (statements.unit != 0) {
    text += fmt::format("  unit       {} m\n", readable(statements.unit));
  }
  if (statements.up != UpAxis::unknown) {
    text += fmt::format("  up axis    {}\n", axis_of(statements.up));
  }
  const Georeference& place = statements.georeference;
  if (!place.empty()) {
    text += fmt::format("  georeference {}\n", printable(describe(place)));
  }
  for (const TileSource& source : tiles.manifest().sources) {
    text += fmt::format("  model      {}: {}, numbered from {}\n", printable(source.file),
                        counted(source.triangles, "triangle"), source.first);
  }
  if (verified) {
    text += "  verified   every box, every number, each triangle in one tile\n";
  }
  return text;
}

}  // namespace

void print_tiles(const std::string& folder, ModelOptions model, bool verify, Console& console) {
  model.allow_empty = true;
  const TileSet tiles = open_tiles(folder, model, {}, console);
  if (verify) {
    console.run("looking at the tiles of " + printable(folder), [&](const Limits& limits) {
      verify_tiles(folder, limits);
      return 0;
    });
  }
  console.print(console.shared().json ? json_line(to_json(folder, tiles))
                                      : to_text(folder, tiles, verify));
  console.flush();
}

}  // namespace soms::command
