#include "soms/tiles/tile_set.h"

#include "soms/base/error.h"
#include "soms/io/detail/file.h"
#include "soms/store/detail/mapped_file.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/detail/manifest.h"
#include "soms/tiles/detail/tile_cache.h"
#include "soms/tiles/detail/tile_ids.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace soms {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw Error(ErrorKind::bad_file, path.string() + ": " + what, "cut the models again: soms tile");
}

}  // namespace

struct TileSet::Content {
  Content(std::filesystem::path folder_, const TileOptions& options_)
      : folder(std::move(folder_)),
        place(std::filesystem::absolute(folder)),
        options(options_),
        cache(options_.max_memory) {}

  [[nodiscard]] detail::TileCache::Opened open(std::size_t number) const;
  void check_same(const Tile& tile, const Shape& shape) const;

  std::filesystem::path folder;  ///< as it was named
  std::filesystem::path place;   ///< wherever the program goes
  TileOptions options;
  TileManifest manifest;
  std::uint64_t triangles = 0;
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;
  Box bounds;
  mutable detail::TileCache cache;
  mutable std::vector<std::atomic<bool>> looked_at;  // tiles that were checked
};

/// A tile that is met first is looked at as the options say, and then its files are trusted as long
/// as their hashes are the same: they appear by a rename, and are not written over.
detail::TileCache::Opened TileSet::Content::open(std::size_t number) const {
  const Tile& tile = manifest.tiles[number];
  const bool first = !looked_at[number];
  const TreeCheck check = first ? options.check : TreeCheck::trusted;
  auto opened = std::make_shared<OpenTile>();
  opened->shape = open_shape(place / tile.file, {.check = check});
  check_same(tile, opened->shape);
  const std::filesystem::path ids = place / tile.ids;
  detail::HeldBytes held = detail::map_file(ids);
  opened->ids = detail::tile_ids_of(held, tile.triangles, ids.string());
  if (options.check >= TreeCheck::safe) {
    const TileSource& source = manifest.sources[tile.source];
    detail::check_tile_ids(opened->ids, source.first, source.first + source.triangles,
                           ids.string());
  }
  if (options.check >= TreeCheck::sound && detail::tile_ids_hash(opened->ids) != tile.ids_hash) {
    fail(ids, "it does not have the hash that the manifest states");
  }
  opened->owner = std::move(held.owner);
  looked_at[number] = true;
  return opened;
}

void TileSet::Content::check_same(const Tile& tile, const Shape& shape) const {
  const std::filesystem::path path = place / tile.file;
  if (shape.tree_file()->hash != tile.hash) {
    fail(path, "it does not have the hash that the manifest states");
  }
  if (shape.mesh().triangles.size() != tile.triangles || shape.bounds() != tile.bounds) {
    fail(path, "its triangles or bounds are not those that the manifest states");
  }
}

bool OpenTile::operator==(const OpenTile& other) const {
  return shape == other.shape &&
         std::equal(ids.begin(), ids.end(), other.ids.begin(), other.ids.end());
}

bool TileSet::operator==(const TileSet& other) const {
  return content_ == other.content_ ||
         (hash() == other.hash() && manifest().tiles == other.manifest().tiles);
}

TileSet::TileSet() : content_(std::make_shared<const Content>(".", TileOptions())) {
}

TileSet TileSet::open(const std::filesystem::path& folder, const TileOptions& options) {
  const std::filesystem::path path = folder / kTileManifest;
  std::error_code unknown;
  if (std::filesystem::is_directory(folder, unknown) && !std::filesystem::exists(path, unknown)) {
    throw Error(ErrorKind::cannot_open, folder.string() + ": it has no " + path.filename().string(),
                "name a folder of tiles; where soms tile was ended, the same command goes on");
  }
  const detail::FileBytes file = detail::read_file(path, std::uint64_t{1} << 32);
  auto content = std::make_shared<Content>(folder, options);
  content->manifest = detail::parse_manifest(file.view(), path.string());
  content->hash = detail::content_hash(content->manifest);
  for (const Tile& tile : content->manifest.tiles) {
    content->triangles += tile.triangles;
    content->bytes += tile.bytes;
    content->bounds.grow(tile.bounds);
  }
  content->looked_at = std::vector<std::atomic<bool>>(content->manifest.tiles.size());
  if (!content->manifest.tiles.empty()) {
    // Every tile keeps what its model states.
    const Shape shape =
        open_shape(content->place / content->manifest.tiles[0].file, {.check = TreeCheck::trusted});
    content->check_same(content->manifest.tiles[0], shape);
    Mesh& statements = content->manifest.statements;
    statements.unit = shape.mesh().unit;
    statements.up = shape.mesh().up;
    statements.georeference = shape.mesh().georeference;
  }
  content->manifest.statements.source = folder.string();
  TileSet set;
  set.content_ = std::move(content);
  return set;
}

const std::filesystem::path& TileSet::folder() const {
  return content_->folder;
}

const std::filesystem::path& TileSet::place() const {
  return content_->place;
}

const TileManifest& TileSet::manifest() const {
  return content_->manifest;
}

std::uint64_t TileSet::triangles() const {
  return content_->triangles;
}

const Box& TileSet::bounds() const {
  return content_->bounds;
}

std::uint64_t TileSet::bytes() const {
  return content_->bytes;
}

std::uint64_t TileSet::hash() const {
  return content_->hash;
}

std::uint64_t TileSet::openings() const {
  return content_->cache.openings();
}

const TileOptions& TileSet::options() const {
  return content_->options;
}

std::shared_ptr<const OpenTile> TileSet::open_tile(std::size_t tile) const {
  const std::uint64_t bytes = content_->manifest.tiles[tile].bytes;
  return content_->cache.get(tile, bytes, [&] { return content_->open(tile); });
}

void verify_tiles(const std::filesystem::path& folder, const Limits& limits) {
  const TileSet set = TileSet::open(folder, {.max_memory = 0, .check = TreeCheck::full});
  std::vector<bool> met(static_cast<std::size_t>(set.triangles()));
  for (std::size_t k = 0; k < set.tiles().size(); ++k) {
    check(limits);
    const Tile& tile = set.tiles()[k];
    std::error_code unknown;
    if (std::filesystem::file_size(set.place() / tile.file, unknown) +
            std::filesystem::file_size(set.place() / tile.ids, unknown) !=
        tile.bytes) {
      fail(set.place() / tile.file, "it has not the bytes that the manifest states");
    }
    for (const std::uint64_t id : set.open_tile(k)->ids) {
      if (met[static_cast<std::size_t>(id)]) {
        fail(set.place() / tile.ids, "triangle " + std::to_string(id) + " is in another tile, too");
      }
      met[static_cast<std::size_t>(id)] = true;  // as many as there are tiles' triangles: all
    }
    if (limits.progress) {
      limits.progress(static_cast<double>(k + 1) / static_cast<double>(set.tiles().size()));
    }
  }
}

bool is_tile_folder(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::is_regular_file(path / kTileManifest, unknown);
}

}  // namespace soms
