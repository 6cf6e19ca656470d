#include "soms/tiles/cut_tiles.h"

#include "soms/base/error.h"
#include "soms/io/detail/file.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/detail/manifest.h"
#include "soms/tiles/detail/tile_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace soms {

namespace {

constexpr std::string_view kTilePrefix = "tile-";
constexpr std::string_view kReceiptPrefix = "source-";

bool is_own_file(const std::string& name) {
  return name == kTileManifest || name.starts_with(kTilePrefix) || name.starts_with(kReceiptPrefix);
}

[[noreturn]] void fail_folder(const std::filesystem::path& folder, const std::error_code& code) {
  throw Error(ErrorKind::cannot_write, folder.string() + ": " + code.message(),
              "name a folder that can be made");
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) {
    fail_folder(folder, code);
  }
  for (auto entry = std::filesystem::directory_iterator(folder, code);
       !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    if (!is_own_file(name) && !name.starts_with(".soms-")) {
      throw Error(ErrorKind::usage, folder.string() + ": it has other files than tiles: " + name,
                  "name a new folder");
    }
  }
  if (code) {
    fail_folder(folder, code);
  }
}

std::uint64_t size_of(const std::filesystem::path& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : static_cast<std::uint64_t>(bytes);
}

/// The files of a tile are there, as they were written.
bool is_whole(const std::filesystem::path& folder, const Tile& tile) {
  try {
    return tree_file_hash(folder / tile.file) == tile.hash &&
           size_of(folder / tile.file) + size_of(folder / tile.ids) == tile.bytes;
  } catch (const Error&) {
    return false;
  }
}

std::vector<std::uint64_t> numbers_of(std::span<const TriangleId> triangles, std::uint64_t first) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(triangles.size());
  for (const TriangleId i : triangles) {
    numbers.push_back(first + i);
  }
  return numbers;
}

}  // namespace

TileCutter::TileCutter(std::filesystem::path folder, const CutOptions& options)
    : folder_(std::move(folder)), options_(options) {
  check(options);
  options_.shape.keep_tree = false;
  make_folder(folder_);
}

bool TileCutter::add(const MeshView& mesh, const Parallel& parallel) {
  check_statements(mesh);
  TileSource source{
      .file = mesh.source, .triangles = mesh.triangles.size(), .hash = corner_hash(mesh)};
  if (!manifest_.sources.empty()) {
    source.first = manifest_.sources.back().first + manifest_.sources.back().triangles;
  }
  if (source.triangles > kMaxTiledTriangles - source.first) {
    throw Error(ErrorKind::out_of_range,
                fmt::format("{}: more than {} triangles in all", mesh.source, kMaxTiledTriangles),
                "make several folders of tiles");
  }
  const bool was_there = take_receipt(source);
  if (!was_there) {
    write_tiles(mesh, source, parallel);
  }
  return !was_there;
}

/// Tiles of one set are in one frame.
void TileCutter::check_statements(const MeshView& mesh) {
  Mesh& first = manifest_.statements;
  if (!begun_) {
    first.unit = mesh.unit;
    first.up = mesh.up;
    first.georeference = mesh.georeference;
    begun_ = true;
    return;
  }
  const auto refuse = [&](std::string_view what) {
    throw Error(ErrorKind::usage,
                fmt::format("{}: its {} is not that of the models before", mesh.source, what),
                "convert it first: soms convert");
  };
  if (first.unit != mesh.unit) {
    refuse("unit");
  }
  if (first.up != mesh.up) {
    refuse("up axis");
  }
  if (first.georeference != mesh.georeference) {
    refuse("georeference");
  }
}

std::filesystem::path TileCutter::receipt() const {
  return folder_ / fmt::format("{}{:06}.json", kReceiptPrefix, manifest_.sources.size());
}

/// What decides the bytes of a model's tiles, in a line.
std::string TileCutter::question(const TileSource& source) const {
  const BuildOptions& build = options_.shape.build;
  return fmt::format(
      "{{\"hash\": \"{}\", \"triangles\": {}, \"first\": {}, \"tile\": {}, \"most\": {}, "
      "\"layout\": {}, \"rule\": {}, \"level\": {}, \"leaf\": {}}}\n",
      detail::hash_text(source.hash), source.triangles, source.first, manifest_.tiles.size(),
      options_.most, static_cast<int>(options_.shape.layout), static_cast<int>(build.rule),
      build.level, build.per_leaf);
}

/// The tiles of a model that was cut whole by an earlier run.
bool TileCutter::take_receipt(const TileSource& source) {
  try {
    const detail::FileBytes file = detail::read_file(receipt(), std::uint64_t{1} << 32);
    const std::string expected = question(source);
    if (!file.view().starts_with(expected)) {
      return false;
    }
    const TileManifest own =
        detail::parse_manifest(file.view().substr(expected.size()), receipt().string());
    if (own.sources.size() != 1 || own.sources[0].file != source.file ||
        !std::all_of(own.tiles.begin(), own.tiles.end(),
                     [&](const Tile& tile) { return is_whole(folder_, tile); })) {
      return false;
    }
    const auto number = static_cast<std::uint32_t>(manifest_.sources.size());
    for (Tile tile : own.tiles) {
      tile.source = number;
      manifest_.tiles.push_back(std::move(tile));
    }
    manifest_.sources.push_back(source);
    return true;
  } catch (const Error&) {
    return false;  // there is none, or it is damaged
  }
}

void TileCutter::write_tiles(const MeshView& mesh, const TileSource& source,
                             const Parallel& parallel) {
  const std::filesystem::path receipt = this->receipt();
  const std::string question = this->question(source);
  std::error_code ignored;
  std::filesystem::remove(folder_ / kTileManifest, ignored);  // it is not true any more
  std::filesystem::remove(receipt, ignored);
  TileManifest own;
  own.sources = {source};
  own.statements = manifest_.statements;
  const std::vector<TileCut> cuts = cut_mesh(mesh, options_.most, parallel);
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const Shape shape(extract(mesh, cuts[k].triangles), options_.shape,
                      {.threads = parallel.threads, .stop = parallel.stop});
    const std::string name =
        fmt::format("{}{:06}", kTilePrefix, manifest_.tiles.size() + own.tiles.size());
    Tile tile{.file = name + ".somst",
              .ids = name + ".npy",
              .triangles = cuts[k].triangles.size(),
              .splits_part = cuts[k].splits_part,
              .bounds = shape.bounds()};
    save(folder_ / tile.file, shape);
    const std::vector<std::uint64_t> ids = numbers_of(cuts[k].triangles, source.first);
    detail::write_whole(folder_ / tile.ids, detail::tile_ids_bytes(ids));
    tile.hash = tree_file_hash(folder_ / tile.file);
    tile.ids_hash = detail::tile_ids_hash(ids);
    tile.bytes = size_of(folder_ / tile.file) + size_of(folder_ / tile.ids);
    own.tiles.push_back(std::move(tile));
    if (parallel.progress) {
      parallel.progress(static_cast<double>(k + 1) / static_cast<double>(cuts.size()));
    }
  }
  detail::write_whole(receipt, question + detail::manifest_text(own));
  const auto number = static_cast<std::uint32_t>(manifest_.sources.size());
  for (Tile& tile : own.tiles) {
    tile.source = number;
    manifest_.tiles.push_back(std::move(tile));
  }
  manifest_.sources.push_back(source);
}

void TileCutter::finish() {
  std::unordered_set<std::string> kept{std::string(kTileManifest)};
  for (const Tile& tile : manifest_.tiles) {
    kept.insert(tile.file);
    kept.insert(tile.ids);
  }
  for (std::size_t k = 0; k < manifest_.sources.size(); ++k) {
    kept.insert(fmt::format("{}{:06}.json", kReceiptPrefix, k));
  }
  // What an earlier run left that cut otherwise.
  std::error_code ignored;
  std::vector<std::filesystem::path> stale;
  for (auto entry = std::filesystem::directory_iterator(folder_, ignored);
       !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (is_own_file(name) && !kept.contains(name)) {
      stale.push_back(entry->path());
    }
  }
  for (const std::filesystem::path& path : stale) {
    std::filesystem::remove(path, ignored);
  }
  detail::write_whole(folder_ / kTileManifest, detail::manifest_text(manifest_));
}

}  // namespace soms
