#include "apps/model/georeference.h"

#include "soms/base/text.h"

#include <algorithm>

namespace soms::command {

namespace {

Json stated_text(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json map_conversion_json(const MapConversion& map) {
  return {{"eastings", map.eastings},
          {"northings", map.northings},
          {"height", map.height},
          {"abscissa", map.abscissa},
          {"ordinate", map.ordinate},
          {"scale", map.scale},
          {"factors", {map.factors.x, map.factors.y, map.factors.z}},
          {"unit", map.unit > 0 ? Json(map.unit) : Json()}};
}

}  // namespace

Georeference georeference_of(std::span<const MeshView> meshes) {
  const auto found = std::find_if(meshes.begin(), meshes.end(),
                                  [](const MeshView& mesh) { return !mesh.georeference.empty(); });
  return found == meshes.end() ? Georeference{} : found->georeference;
}

Json georeference_json(const Georeference& georeference) {
  if (georeference.empty()) {
    return {};
  }
  const auto& map = georeference.map_conversion;
  return {{"crs", stated_text(georeference.crs)},
          {"vertical_datum", stated_text(georeference.vertical_datum)},
          {"map_conversion", map ? map_conversion_json(*map) : Json()}};
}

void add_georeference(Json& json, const Georeference& georeference) {
  if (!georeference.empty()) {
    json["georeference"] = georeference_json(georeference);
  }
}

GeoreferenceColumn::GeoreferenceColumn(const Georeference& georeference)
    : head_(georeference.empty() ? "" : ",georeference"),
      field_(georeference.empty() ? "" : "," + csv_field(describe(georeference))) {
}

}  // namespace soms::command
