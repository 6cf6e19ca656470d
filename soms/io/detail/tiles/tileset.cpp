#include "soms/io/detail/tiles/tileset.h"

#include "soms/io/detail/cityjson/cityjson.h"
#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/json_document.h"
#include "soms/io/detail/named_file.h"
#include "soms/io/detail/tiles/tile_content.h"
#include "soms/io/detail/tiles/tile_meshes.h"
#include "soms/io/detail/tiles/tile_tree.h"
#include "soms/io/encoding.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace soms::detail {

namespace {

constexpr std::size_t kDeepestTileset = 16;  ///< tilesets within each other

using FileId = std::pair<std::uint64_t, std::uint64_t>;

/// Reads the tiles of a tileset, and of those that it names.
class TilesetReader {
 public:
  explicit TilesetReader(Source& source) : source_(source) {
    quiet_.stop = source.limits.stop;
    quiet_.threads = source.limits.threads;
  }

  [[nodiscard]] Mesh read();

 private:
  /// A tileset that is open.
  struct Level {
    Source& source;
    std::string folder;  ///< of its files, from that of the first tileset; ends with '/' if any
    bool turned = true;
  };

  void read_tileset(Source& source, std::string folder, const Affine& around,
                    Refinement refinement);
  void read_tile(Level& level, const JsonValue& json, const Affine& around, Refinement refinement);
  void read_content(Level& level, const Tile& tile, const TileContent& content);
  void read_nested(Source& nested, const JsonValue& uri, const FileId& id, const std::string& name,
                   const Tile& tile);
  void keep(Source& source, Mesh mesh, std::string name, const TileContent& content);
  void add_notes(Mesh& mesh) const;

  Source& source_;
  Limits quiet_;  ///< progress is of tiles, not of the bytes of each
  std::vector<NamedMesh> meshes_;
  std::set<FileId> files_;  ///< that were read
  std::vector<FileId> open_tilesets_;
  std::set<FileId> tilesets_;
  bool has_regions_ = false;
  TileLeftOut unread_;
  LeftOut coarse_;
  LeftOut outside_;
};

/// Does something to a content; its errors name the place in the tileset, too.
template <class Action>
void at_content(const JsonValue& uri, const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    uri.fail(error.kind(), error.place(), error.remedy());
  }
}

/// What stands before the last slash of a name, with it.
std::string folder_part(const std::string& name) {
  return name.substr(0, name.find_last_of('/') + 1);
}

void TilesetReader::keep(Source& source, Mesh mesh, std::string name, const TileContent& content) {
  if (content.volume) {
    has_regions_ = has_regions_ || content.volume->is_region();
    const std::uint64_t count = count_outside(mesh, *content.volume);
    outside_.add([&] { return "in " + name; }, count);
  }
  const std::uint64_t bytes = 2 * sizeof(NamedMesh) + name.size();
  if (!source.budget.take(bytes)) {
    source.fail_memory(bytes);
  }
  meshes_.push_back({std::move(name), std::move(mesh)});
}

/// A tileset that a tile holds: its root stands in the tile as a child would.
void TilesetReader::read_nested(Source& nested, const JsonValue& uri, const FileId& id,
                                const std::string& name, const Tile& tile) {
  if (std::find(open_tilesets_.begin(), open_tilesets_.end(), id) != open_tilesets_.end()) {
    uri.fail("the tileset " + in_quotes(uri.text()) + " is within itself");
  }
  if (open_tilesets_.size() >= kDeepestTileset) {
    uri.fail("tilesets are nested more than " + std::to_string(kDeepestTileset) + " deep");
  }
  if (!tilesets_.insert(id).second) {
    uri.fail(ErrorKind::unsupported,
             "the tileset " + in_quotes(uri.text()) + " is named a second time",
             "name each tileset once");
  }
  open_tilesets_.push_back(id);
  at_content(uri, [&] { read_tileset(nested, folder_part(name), tile.frame, tile.refinement); });
  open_tilesets_.pop_back();
}

void TilesetReader::read_content(Level& level, const Tile& tile, const TileContent& content) {
  Source& source = level.source;
  const NamedFile named = open_named(source, content.uri);
  const FileId id = named.file.id();
  const FileBytes bytes = read_named(source, named, content.uri, !files_.insert(id).second);
  const std::string name = level.folder + without_escapes(content.uri.text());
  Source inner{.bytes = bytes.view(),
               .name = (*source_.folder / name).string(),
               .folder = named.path.parent_path(),
               .budget = source.budget,
               .memory_per_byte = source.memory_per_byte,
               .limits = quiet_};
  refuse_utf16(inner.bytes, inner.name);
  skip_byte_order_mark(inner);
  if (inner.bytes.empty()) {
    content.uri.fail(in_quotes(content.uri.text()) + ": the file is empty");
  }
  if (is_tileset(inner.bytes)) {
    read_nested(inner, content.uri, id, name, tile);
  } else if (is_cityjson(inner.bytes)) {
    content.uri.fail("no content of a tile is CityJSON");
  } else {
    at_content(content.uri, [&] {
      const TileFrame frame{.frame = tile.frame, .turned = level.turned};
      const auto place = [&] { return "at " + content.uri.path(); };
      keep(inner, read_tile_content(inner, frame, place, unread_), name, content);
    });
  }
  source.budget = inner.budget;
  source.budget.give_back(bytes.size);
}

void TilesetReader::read_tile(Level& level, const JsonValue& json, const Affine& around,
                              Refinement refinement) {
  check(source_.limits);
  const Tile tile = tile_of(json, around, refinement);
  if (tile.refinement == Refinement::replace && !tile.contents.empty() && has_content_below(json)) {
    coarse_.add([&] { return "at " + json.path(); }, tile.contents.size());
  } else {
    for (const TileContent& content : tile.contents) {
      read_content(level, tile, content);
    }
  }
  for (std::size_t i = 0; tile.children && i < tile.children->size(); ++i) {
    read_tile(level, tile.children->at(i), tile.frame, tile.refinement);
  }
}

void TilesetReader::read_tileset(Source& source, std::string folder, const Affine& around,
                                 Refinement refinement) {
  const JsonDocument document(source, source.bytes, 0, false);
  const JsonValue root = document.root();
  check_tileset(root);
  Level level{source, std::move(folder), contents_are_y_up(root)};
  read_tile(level, root.at("root"), around, refinement);
}

void TilesetReader::add_notes(Mesh& mesh) const {
  add_note(mesh.notes, coarse_, "contents of another level of detail, not read");
  unread_.add_notes(mesh.notes);
  add_note(mesh.notes, outside_, "vertices outside of the volumes of their tiles");
}

Mesh TilesetReader::read() {
  read_tileset(source_, {}, Affine{}, Refinement::replace);
  Mesh mesh = join_tiles(source_, std::move(meshes_));
  add_notes(mesh);
  finish_tiles(source_, mesh);
  // Regions are places on the Earth: so are the coordinates beside them.
  if (has_regions_) {
    state_earth_centered(mesh);
  }
  return mesh;
}

/// True if an object of JSON has one of these members itself, not in another. What is no JSON may
/// be taken for it: its reader says what is wrong.
template <std::size_t N>
bool has_member(std::string_view bytes, const std::array<std::string_view, N>& names) {
  int depth = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const char c = bytes[i];
    if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
    } else if (c == '"') {
      const std::size_t begin = ++i;
      while (i < bytes.size() && bytes[i] != '"') {
        i += bytes[i] == '\\' ? 2U : 1U;
      }
      const std::size_t colon = bytes.find_first_not_of(" \t\r\n", i + 1);
      if (depth == 1 && colon != std::string_view::npos && bytes[colon] == ':' &&
          std::find(names.begin(), names.end(), bytes.substr(begin, i - begin)) != names.end()) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

bool is_tileset(std::string_view bytes) {
  constexpr std::array<std::string_view, 2> kOwn = {"root", "geometricError"};
  constexpr std::array<std::string_view, 4> kOfGltf = {"accessors", "meshes", "nodes", "scenes"};
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && bytes[begin] == '{' &&
         bytes.find("\"asset\"", begin) != std::string_view::npos &&
         (bytes.find("\"root\"") != std::string_view::npos ||
          bytes.find("\"geometricError\"") != std::string_view::npos) &&
         has_member(bytes, kOwn) && !has_member(bytes, kOfGltf) && !is_cityjson(bytes);
}

Mesh read_tileset(Source& source) {
  return TilesetReader(source).read();
}

}  // namespace soms::detail
