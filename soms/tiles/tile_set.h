/// \file
/// A model cut into tiles, each a tree file: for models larger than memory, such as a country. The
/// command `soms tile` and `cut_tiles.h` make them; `tiled_queries.h` has the questions.
#pragma once

#include "soms/base/box.h"
#include "soms/base/limits.h"
#include "soms/base/pose.h"
#include "soms/geometry/mesh.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soms {

/// The file of a folder of tiles that says which there are. It is written last.
inline constexpr std::string_view kTileManifest = "tiles.json";

/// Most triangles of all tiles together: numbers of triangles have 32 bits.
inline constexpr std::uint64_t kMaxTiledTriangles = 0xffff'ffff;

/// A model that was cut into tiles.
struct TileSource {
  std::string file;             ///< as it was named
  std::uint64_t first = 0;      ///< the number of its first triangle
  std::uint64_t triangles = 0;  ///< how many it has
  std::uint64_t hash = 0;       ///< `corner_hash` of its mesh

  [[nodiscard]] bool operator==(const TileSource&) const = default;
};

/// A tile: some triangles of one source.
struct Tile {
  std::string file;             ///< its tree file, in the folder
  std::string ids;              ///< its triangles' numbers, ascending, as an array of NumPy
  std::uint64_t hash = 0;       ///< of the tree file's content
  std::uint64_t ids_hash = 0;   ///< `lanes_hash` of the bytes of the numbers
  std::uint64_t bytes = 0;      ///< of both files
  std::uint64_t triangles = 0;  ///< at least 1
  std::uint32_t source = 0;     ///< index of its source
  bool splits_part = false;     ///< one of its parts has triangles in another tile
  Box bounds;                   ///< of its triangles, unmoved

  [[nodiscard]] bool operator==(const Tile&) const = default;
};

/// What a folder of tiles says of itself.
struct TileManifest {
  std::vector<TileSource> sources;
  std::vector<Tile> tiles;
  /// Unit, up axis and georeference of all sources, without triangles.
  Mesh statements;

  [[nodiscard]] bool operator==(const TileManifest&) const = default;
};

/// How tiles are opened.
struct TileOptions {
  /// Most bytes of tile files that are mapped at a time, beside those in use by a thread. The
  /// tile that was not met for the longest time goes first.
  std::uint64_t max_memory = std::numeric_limits<std::uint64_t>::max();
  /// How closely a tile is looked at when it is met first. Met again, its hash is compared.
  TreeCheck check = TreeCheck::sound;

  [[nodiscard]] bool operator==(const TileOptions&) const = default;
};

/// A tile that is open, as long as this lives.
struct OpenTile {
  Shape shape;
  /// Entry k is the number of triangle k of the shape among those of all tiles; ascending.
  std::span<const std::uint64_t> ids;
  std::shared_ptr<const void> owner;  ///< keeps `ids`

  /// Equal shapes and numbers.
  [[nodiscard]] bool operator==(const OpenTile& other) const;

  /// The number among all triangles of the tile's own triangle.
  [[nodiscard]] TriangleId number(TriangleId triangle) const {
    return static_cast<TriangleId>(ids[triangle]);
  }
};

/// A folder of tiles. Copies share what is open. Many threads may use one at once.
class TileSet {
 public:
  /// No tiles.
  TileSet();

  /// Opens a folder of tiles. Tiles are opened when a question meets them.
  /// \errors  ErrorKind::cannot_open; bad_file (names the entry of the manifest); unsupported for
  ///          another version of the format.
  /// \cost    O(t log t) for t tiles.
  [[nodiscard]] static TileSet open(const std::filesystem::path& folder,
                                    const TileOptions& options = {});

  /// As it was named when it was opened.
  [[nodiscard]] const std::filesystem::path& folder() const;

  /// The same, absolute.
  [[nodiscard]] const std::filesystem::path& place() const;

  [[nodiscard]] const TileManifest& manifest() const;

  [[nodiscard]] std::span<const Tile> tiles() const { return manifest().tiles; }

  /// The number of triangles of all tiles.
  [[nodiscard]] std::uint64_t triangles() const;

  /// Bounds of all triangles; empty without any.
  [[nodiscard]] const Box& bounds() const;

  /// Bytes of all tile files.
  [[nodiscard]] std::uint64_t bytes() const;

  /// A number that stands for the content of all tiles, whatever their models are called.
  [[nodiscard]] std::uint64_t hash() const;

  /// Opens a tile, unless it is open.
  /// \errors  As `open_shape`; ErrorKind::bad_file for a tile that is not the one of the manifest.
  [[nodiscard]] std::shared_ptr<const OpenTile> open_tile(std::size_t tile) const;

  /// How often a tile file was opened so far.
  [[nodiscard]] std::uint64_t openings() const;

  /// How the tiles are opened.
  [[nodiscard]] const TileOptions& options() const;

  /// Equal tiles, by their hashes, wherever they are.
  [[nodiscard]] bool operator==(const TileSet& other) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

/// Looks at all files of a folder: every box, every number, and that each triangle is in one tile.
/// Tiles are opened one by one.
/// \errors  As `TileSet::open`; ErrorKind::bad_file, which names the file; cancelled.
/// \cost    That of reading all bytes, and of half a build; a bit a triangle.
void verify_tiles(const std::filesystem::path& folder, const Limits& limits = {});

/// True if the path is a folder with a manifest of tiles.
[[nodiscard]] bool is_tile_folder(const std::filesystem::path& path);

/// Tiles where a pose has moved them, as `Body` is a shape.
struct TiledBody {
  TileSet tiles = {};
  Pose pose = {};

  [[nodiscard]] bool operator==(const TiledBody&) const = default;
};

/// One line, as in soms/base/print.h. Lists are counted, not listed.
std::ostream& operator<<(std::ostream& out, const OpenTile& value);
std::ostream& operator<<(std::ostream& out, const Tile& value);
std::ostream& operator<<(std::ostream& out, const TiledBody& value);
std::ostream& operator<<(std::ostream& out, const TileManifest& value);
std::ostream& operator<<(std::ostream& out, const TileOptions& value);
std::ostream& operator<<(std::ostream& out, const TileSet& value);
std::ostream& operator<<(std::ostream& out, const TileSource& value);

}  // namespace soms
