#include "soms/io/detail/tiles/tile_tree.h"

#include "soms/io/detail/json_numbers.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace soms::detail {

namespace {

constexpr const char* kExplicit =
    "make a tileset with explicit tiles and one content each (3d-tiles-tools convert)";

void refuse(const JsonValue& place, std::string_view what) {
  place.fail(ErrorKind::unsupported, std::string(what) + ", which is not read", kExplicit);
}

/// Extensions that change neither which tiles there are nor where they stand.
bool is_harmless_extension(std::string_view name) {
  constexpr std::array<std::string_view, 4> kHarmless = {"3DTILES_content_gltf", "3DTILES_metadata",
                                                         "3DTILES_bounding_volume_S2",
                                                         "3DTILES_batch_table_hierarchy"};
  return std::find(kHarmless.begin(), kHarmless.end(), name) != kHarmless.end();
}

void check_geometric_error(const JsonValue& holder) {
  const JsonValue error = holder.at("geometricError");
  if (!(error.number() >= 0)) {
    error.fail("the geometric error must be 0 or more");
  }
}

Refinement refinement_of(const JsonValue& json, Refinement around) {
  const std::optional<JsonValue> stated = json.find("refine");
  if (!stated) {
    return around;
  }
  const std::string_view word = stated->text();
  if (word == "ADD" || word == "add") {
    return Refinement::add;
  }
  if (word != "REPLACE" && word != "replace") {
    stated->fail(in_quotes(word) + " is neither \"ADD\" nor \"REPLACE\"");
  }
  return Refinement::replace;
}

void refuse_implicit(const JsonValue& json) {
  if (const auto implicit = json.find("implicitTiling")) {
    refuse(*implicit, "implicit tiling");
  }
  const std::optional<JsonValue> extensions = json.find("extensions");
  for (const auto& [name, what] :
       {std::pair{"3DTILES_implicit_tiling", "implicit tiling"},
        std::pair{"3DTILES_multiple_contents", "several contents by an extension"}}) {
    if (const auto used = extensions ? extensions->find(name) : std::nullopt) {
      refuse(*used, what);
    }
  }
}

TileContent content_of(const JsonValue& json, const Tile& tile,
                       const std::optional<TileVolume>& volume) {
  // Tilesets from before the standard say "url".
  const std::optional<JsonValue> old = json.find("uri") ? std::nullopt : json.find("url");
  const JsonValue named = old ? *old : json.at("uri");
  static_cast<void>(named.text());
  const std::optional<JsonValue> own = json.find("boundingVolume");
  return {named, own ? TileVolume::read(*own, tile.frame) : volume};
}

}  // namespace

void check_tileset(const JsonValue& root) {
  const JsonValue version = root.at("asset").at("version");
  if (version.text() != "1.0" && version.text() != "1.1") {
    version.fail(ErrorKind::unsupported,
                 "version " + in_quotes(version.text()) + " is not read, only 1.0 and 1.1",
                 "save the tileset as 3D Tiles 1.0 or 1.1");
  }
  check_geometric_error(root);
  const std::optional<JsonValue> required = root.find("extensionsRequired");
  for (std::size_t i = 0; required && i < required->size(); ++i) {
    if (!is_harmless_extension(required->at(i).text())) {
      refuse(required->at(i), "the extension " + in_quotes(required->at(i).text()));
    }
  }
}

bool contents_are_y_up(const JsonValue& root) {
  const std::optional<JsonValue> axis = root.at("asset").find("gltfUpAxis");
  if (!axis || axis->text() == "Y" || axis->text() == "y") {
    return true;
  }
  if (axis->text() != "Z" && axis->text() != "z") {
    refuse(*axis, "the up axis " + in_quotes(axis->text()) + " of glTF");
  }
  return false;
}

Tile tile_of(const JsonValue& json, const Affine& around, Refinement refinement) {
  refuse_implicit(json);
  Tile tile{.json = json, .frame = around, .refinement = refinement_of(json, refinement)};
  if (const auto transform = json.find("transform")) {
    tile.frame = around * json_matrix(*transform);
  }
  const std::optional<TileVolume> volume = TileVolume::read(json.at("boundingVolume"), tile.frame);
  check_geometric_error(json);
  const std::optional<JsonValue> content = json.find("content");
  const std::optional<JsonValue> contents = json.find("contents");
  if (content && contents) {
    json.fail("both \"content\" and \"contents\"");
  }
  if (content) {
    tile.contents.push_back(content_of(*content, tile, volume));
  }
  for (std::size_t i = 0; contents && i < contents->size(); ++i) {
    tile.contents.push_back(content_of(contents->at(i), tile, volume));
  }
  tile.children = json.find("children");
  return tile;
}

bool has_content_below(const JsonValue& tile) {
  const std::optional<JsonValue> children = tile.find("children");
  for (std::size_t i = 0; children && i < children->size(); ++i) {
    const JsonValue child = children->at(i);
    if (child.find("content") || child.find("contents") || has_content_below(child)) {
      return true;
    }
  }
  return false;
}

}  // namespace soms::detail
