#include "soms/tiles/cut_tiles.h"

#include "soms/base/error.h"
#include "soms/base/lanes_hash.h"
#include "soms/geometry/georeference.h"
#include "soms/geometry/print.h"
#include "soms/io/detail/file.h"
#include "soms/io/detail/json_document.h"
#include "soms/store/detail/mapped_file.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/detail/manifest.h"
#include "soms/tiles/detail/tile_ids.h"
#include "soms/tree/file/detail/statements.h"
#include "soms/tree/print.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <sstream>
#include <string_view>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace soms {

namespace {

constexpr std::string_view kTilePrefix = "tile-";
constexpr std::string_view kReceiptPrefix = "source-";
constexpr std::size_t kDigits = 6;  // or more

/// PREFIX, six digits or more, and one of the extensions.
bool is_numbered(std::string_view name, std::string_view prefix,
                 std::initializer_list<std::string_view> extensions) {
  if (!name.starts_with(prefix)) {
    return false;
  }
  name.remove_prefix(prefix.size());
  const std::size_t digits = name.find_first_not_of("0123456789");
  return digits != std::string_view::npos && digits >= kDigits &&
         std::find(extensions.begin(), extensions.end(), name.substr(digits)) != extensions.end();
}

bool is_tile_file(std::string_view name) {
  return is_numbered(name, kTilePrefix, {".somst", ".npy"});
}

bool is_receipt(std::string_view name) {
  return is_numbered(name, kReceiptPrefix, {".json"});
}

std::string receipt_name(std::size_t source) {
  return fmt::format("{}{:06}.json", kReceiptPrefix, source);
}

[[noreturn]] void fail_folder(const std::filesystem::path& folder, const std::error_code& code) {
  throw Error(ErrorKind::cannot_write, folder.string() + ": " + code.message(),
              "name a folder that can be made");
}

/// Names of files in a folder; none if it is not there.
std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  if (!std::filesystem::exists(folder, code)) {
    return names;
  }
  for (auto entry = std::filesystem::directory_iterator(folder, code);
       !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    names.push_back(entry->path().filename().string());
  }
  if (code) {
    fail_folder(folder, code);
  }
  return names;
}

/// What is there is a folder of tiles, or of what became of one.
void check_folder(const std::filesystem::path& folder) {
  for (const std::string& name : names_in(folder)) {
    std::error_code unknown;
    const bool own = name == kTileManifest || is_tile_file(name) || is_receipt(name);
    if (!own && !name.starts_with(".soms-")) {
      throw Error(ErrorKind::usage, folder.string() + ": it has other files than tiles: " + name,
                  "name a new folder");
    }
    if (own && !std::filesystem::is_regular_file(
                   std::filesystem::symlink_status(folder / name, unknown))) {
      throw Error(ErrorKind::cannot_write, (folder / name).string() + ": not a regular file",
                  "remove it, or name a new folder");
    }
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) {
    fail_folder(folder, code);
  }
}

std::uint64_t size_of(const std::filesystem::path& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : static_cast<std::uint64_t>(bytes);
}

/// The files of a tile are there, as they were written. \cost That of reading them.
bool is_whole(const std::filesystem::path& folder, const Tile& tile) {
  try {
    if (size_of(folder / tile.file) + size_of(folder / tile.ids) != tile.bytes) {
      return false;
    }
    const Shape shape = open_shape(folder / tile.file);
    const detail::HeldBytes ids = detail::map_file(folder / tile.ids);
    return shape.tree_file()->hash == tile.hash && shape.bounds() == tile.bounds &&
           detail::tile_ids_hash(detail::tile_ids_of(ids, tile.triangles, tile.ids)) ==
               tile.ids_hash;
  } catch (const Error&) {
    return false;
  }
}

/// "1", "unknown": of two models that do not go together.
template <class Value>
std::string words_of(const Value& value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::vector<std::uint64_t> numbers_of(std::span<const TriangleId> triangles, std::uint64_t first) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(triangles.size());
  for (const TriangleId i : triangles) {
    numbers.push_back(first + i);
  }
  return numbers;
}

void check_options(const CutOptions& options) {
  check(options.shape.build);
  if (options.most == 0) {
    throw Error(ErrorKind::usage, "cut options: at most 0 triangles of a tile",
                "allow one at least; a million is usual");
  }
}

}  // namespace

TileCutter::TileCutter(std::filesystem::path folder, const CutOptions& options)
    : folder_(std::move(folder)), options_(options) {
  check_options(options);
  options_.shape.keep_tree = false;
  check_folder(folder_);
}

bool TileCutter::add(const MeshView& mesh, const Limits& limits) {
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
  const bool was_there = take_receipt(mesh, source);
  if (!was_there) {
    write_tiles(mesh, source, limits);
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
  const auto check_same = [&](std::string_view what, const std::string& own,
                              const std::string& others) {
    if (own != others) {
      throw Error(ErrorKind::usage,
                  fmt::format("{}: its {} is {}, and that of the models before is {}",
                              mesh.source.empty() ? "a mesh" : mesh.source, what, own, others),
                  "cut it into a folder of its own, or give it what the others state");
    }
  };
  check_same("unit", words_of(mesh.unit), words_of(first.unit));
  check_same("up axis", words_of(mesh.up), words_of(first.up));
  check_same("georeference", describe(mesh.georeference), describe(first.georeference));
}

std::filesystem::path TileCutter::receipt() const {
  return folder_ / receipt_name(manifest_.sources.size());
}

/// What decides the bytes of a model's tiles, in a line.
std::string TileCutter::question(const MeshView& mesh, const TileSource& source) const {
  const std::string statements = detail::bytes_of_statements(mesh);
  return fmt::format(
      "{{\"hash\": \"{}\", \"statements\": \"{}\", \"faces\": \"{}\", \"first\": {}, "
      "\"tile\": {}, \"most\": {}, \"shape\": {}}}\n",
      detail::hash_text(source.hash),
      detail::hash_text(lanes_hash(std::as_bytes(std::span(statements)))),
      detail::hash_text(lanes_hash(std::as_bytes(mesh.faces))), source.first,
      manifest_.tiles.size(), options_.most, detail::json_text(words_of(options_.shape)));
}

/// Takes the tiles of a model that was cut whole by an earlier run.
/// \errors ErrorKind::usage for a folder of other models, or cut otherwise.
bool TileCutter::take_receipt(const MeshView& mesh, const TileSource& source) {
  std::error_code unknown;
  if (!std::filesystem::exists(receipt(), unknown)) {
    return false;
  }
  const detail::FileBytes file = detail::read_file(receipt(), std::uint64_t{1} << 32);
  const std::string expected = question(mesh, source);
  if (!file.view().starts_with(expected)) {
    throw Error(ErrorKind::usage,
                fmt::format("{}: it was cut from other models than {}, or otherwise",
                            folder_.string(), mesh.source.empty() ? "this mesh" : mesh.source),
                "name a new folder, or remove this one");
  }
  try {
    const TileManifest own =
        detail::parse_manifest(file.view().substr(expected.size()), receipt().string());
    if (own.sources.size() != 1 ||
        !std::all_of(own.tiles.begin(), own.tiles.end(),
                     [&](const Tile& tile) { return is_whole(folder_, tile); })) {
      return false;
    }
    keep(source, own.tiles);
    return true;
  } catch (const Error&) {
    return false;  // the receipt is damaged
  }
}

void TileCutter::keep(const TileSource& source, std::span<const Tile> tiles) {
  const auto number = static_cast<std::uint32_t>(manifest_.sources.size());
  for (Tile tile : tiles) {
    tile.source = number;
    manifest_.tiles.push_back(std::move(tile));
  }
  manifest_.sources.push_back(source);
}

void TileCutter::write_tiles(const MeshView& mesh, const TileSource& source, const Limits& limits) {
  const std::filesystem::path receipt = this->receipt();
  const std::string question = this->question(mesh, source);
  make_folder(folder_);
  std::error_code ignored;
  std::filesystem::remove(folder_ / kTileManifest, ignored);  // it is not true any more
  std::filesystem::remove(receipt, ignored);
  TileManifest own;
  own.sources = {source};
  own.statements = manifest_.statements;
  const std::vector<TileCut> cuts = cut_mesh(mesh, options_.most, limits);
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const Shape shape(extract(mesh, cuts[k].triangles), options_.shape,
                      {.threads = limits.threads, .stop = limits.stop});
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
    if (limits.progress) {
      limits.progress(static_cast<double>(k + 1) / static_cast<double>(cuts.size()));
    }
  }
  detail::write_whole(receipt, question + detail::manifest_text(own));
  keep(source, own.tiles);
}

void TileCutter::finish() {
  std::unordered_set<std::string> kept;
  for (const Tile& tile : manifest_.tiles) {
    kept.insert(tile.file);
    kept.insert(tile.ids);
  }
  for (std::size_t k = 0; k < manifest_.sources.size(); ++k) {
    kept.insert(receipt_name(k));
  }
  const std::vector<std::string> names = names_in(folder_);
  if (std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return is_receipt(name) && !kept.contains(name);
      })) {
    throw Error(ErrorKind::usage, folder_.string() + ": it was cut from more models than these",
                "name all of them, or a new folder");
  }
  std::error_code ignored;
  // Tiles of a run that was ended before its model was whole, and that cut it otherwise.
  for (const std::string& name : names) {
    if (is_tile_file(name) && !kept.contains(name)) {
      std::filesystem::remove(folder_ / name, ignored);
    }
  }
  make_folder(folder_);
  detail::write_whole(folder_ / kTileManifest, detail::manifest_text(manifest_));
}

}  // namespace soms
