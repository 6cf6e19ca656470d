#include "soms/tiles/detail/manifest.h"

#include "soms/base/decimal.h"
#include "soms/base/error.h"
#include "soms/base/lanes_hash.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/output.h"
#include "soms/io/detail/source.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <system_error>

namespace soms::detail {

namespace {

constexpr std::string_view kFormat = "soms.tiles/";
constexpr std::string_view kVersion = "1";
constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 44;  // of a tile: sums of all do not wrap
constexpr std::array<std::string_view, 4> kAxes{"unknown", "x", "y", "z"};

std::string number_text(double number) {
  std::array<char, 32> digits;
  return {digits.data(), write_shortest(digits.data(), digits.data() + digits.size(), number)};
}

std::string point_text(const Vec3& point) {
  return fmt::format("[{}, {}, {}]", number_text(point.x), number_text(point.y),
                     number_text(point.z));
}

std::uint64_t hash_of(const JsonValue& value) {
  const std::string_view text = value.text();
  std::uint64_t hash = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (text.size() != 16 || read.ec != std::errc() || read.ptr != text.data() + text.size()) {
    value.fail("a hash has 16 digits 0 to f");
  }
  return hash;
}

Vec3 point_of(const JsonValue& value) {
  if (value.size() != 3) {
    value.fail("a point has three numbers");
  }
  return {value.at(0).number(), value.at(1).number(), value.at(2).number()};
}

/// A file in the folder, and nowhere else.
std::string file_of(const JsonValue& value) {
  const std::string_view text = value.text();
  if (text.empty() || text.find('/') != std::string_view::npos ||
      text.find('\0') != std::string_view::npos || text == "." || text == "..") {
    value.fail("a tile is a file in the folder of its manifest");
  }
  return std::string(text);
}

TileSource source_of(const JsonValue& value, std::uint64_t first) {
  TileSource source;
  source.file = value.at("file").text();
  source.first = first;
  source.triangles = value.at("triangles").whole();
  source.hash = hash_of(value.at("hash"));
  if (source.triangles > kMaxTiledTriangles - first) {
    value.fail("more triangles than numbers of 32 bits");
  }
  return source;
}

Tile tile_of(const JsonValue& value, const std::vector<TileSource>& sources) {
  Tile tile;
  tile.file = file_of(value.at("file"));
  tile.ids = file_of(value.at("ids"));
  tile.hash = hash_of(value.at("hash"));
  tile.ids_hash = hash_of(value.at("ids_hash"));
  tile.bytes = value.at("bytes").whole();
  tile.triangles = value.at("triangles").whole();
  tile.splits_part = value.at("splits_part").boolean();
  const std::uint64_t source = value.at("source").whole();
  if (source >= sources.size()) {
    value.at("source").fail("there is no such source");
  }
  tile.source = static_cast<std::uint32_t>(source);
  if (tile.triangles == 0 || tile.triangles > sources[tile.source].triangles) {
    value.at("triangles").fail("a tile has triangles of its source");
  }
  if (tile.bytes > kMostBytes) {
    value.at("bytes").fail("no tile has so many bytes");
  }
  tile.bounds = {point_of(value.at("lower")), point_of(value.at("upper"))};
  if (tile.bounds.empty()) {
    value.fail("a tile's lower corner is above its upper corner");
  }
  return tile;
}

/// Each triangle is in one tile, so the counts are equal.
void check_counts(const TileManifest& manifest, const JsonValue& root) {
  std::vector<std::uint64_t> counts(manifest.sources.size());
  for (const Tile& tile : manifest.tiles) {
    counts[tile.source] += tile.triangles;
  }
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts[s] != manifest.sources[s].triangles) {
      root.fail(fmt::format("the tiles of source {} have {} triangles, and it has {}", s, counts[s],
                            manifest.sources[s].triangles));
    }
  }
}

UpAxis axis_of(const JsonValue& value) {
  const std::string_view text = value.text();
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    if (text == kAxes[k]) {
      return static_cast<UpAxis>(k);
    }
  }
  value.fail("an up axis is x, y, z or unknown");
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

std::string manifest_text(const TileManifest& manifest) {
  const Mesh& mesh = manifest.statements;
  std::string text =
      fmt::format("{{\"schema\": \"{}{}\",\n\"unit\": {},\n\"up\": \"{}\",\n\"crs\": {},\n",
                  kFormat, kVersion, number_text(mesh.unit),
                  kAxes[static_cast<std::size_t>(mesh.up)], json_text(mesh.georeference.crs));
  text += "\"sources\": [";
  std::string_view before = "\n";
  for (const TileSource& source : manifest.sources) {
    text += fmt::format("{}{{\"file\": {}, \"triangles\": {}, \"hash\": \"{}\"}}", before,
                        json_text(source.file), source.triangles, hash_text(source.hash));
    before = ",\n";
  }
  text += "],\n\"tiles\": [";
  before = "\n";
  for (const Tile& tile : manifest.tiles) {
    text += fmt::format(
        "{}{{\"file\": {}, \"ids\": {}, \"hash\": \"{}\", \"ids_hash\": \"{}\", \"bytes\": {}, "
        "\"triangles\": {}, \"source\": {}, \"splits_part\": {}, \"lower\": {}, \"upper\": {}}}",
        before, json_text(tile.file), json_text(tile.ids), hash_text(tile.hash),
        hash_text(tile.ids_hash), tile.bytes, tile.triangles, tile.source, tile.splits_part,
        point_text(tile.bounds.lower), point_text(tile.bounds.upper));
    before = ",\n";
  }
  return text + "]}\n";
}

TileManifest parse_manifest(std::string_view text, const std::string& name) {
  const Limits alone;
  Source source{.bytes = text,
                .name = name,
                .budget = Budget(64 * text.size() + (std::uint64_t{64} << 20)),
                .limits = alone};
  const JsonDocument document(source, text, 0, false);
  const JsonValue root = document.root();
  const std::string_view schema = root.at("schema").text();
  if (!schema.starts_with(kFormat)) {
    root.at("schema").fail("no manifest of tiles");
  }
  if (schema.substr(kFormat.size()) != kVersion) {
    root.at("schema").fail(ErrorKind::unsupported,
                           "another version of the format: " + std::string(schema),
                           "cut the models again: soms tile");
  }
  TileManifest manifest;
  manifest.statements.unit = root.at("unit").number();
  if (!(manifest.statements.unit >= 0)) {
    root.at("unit").fail("a unit is a length");
  }
  manifest.statements.up = axis_of(root.at("up"));
  manifest.statements.georeference.crs = root.at("crs").text();
  const JsonValue sources = root.at("sources");
  std::uint64_t first = 0;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    manifest.sources.push_back(source_of(sources.at(k), first));
    first += manifest.sources.back().triangles;
  }
  const JsonValue tiles = root.at("tiles");
  for (std::size_t k = 0; k < tiles.size(); ++k) {
    manifest.tiles.push_back(tile_of(tiles.at(k), manifest.sources));
  }
  check_counts(manifest, root);
  return manifest;
}

std::uint64_t content_hash(TileManifest manifest) {
  for (TileSource& source : manifest.sources) {
    source.file.clear();
  }
  const std::string text = manifest_text(manifest);
  return lanes_hash(std::as_bytes(std::span(text)));
}

void write_whole(const std::filesystem::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace soms::detail
