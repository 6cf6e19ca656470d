#include "soms/io/detail/tiles/tile_content.h"

#include "soms/io/detail/cityjson/geodesy.h"
#include "soms/io/detail/gltf/gltf.h"
#include "soms/io/detail/numbers/little_endian.h"
#include "soms/io/detail/tiles/b3dm.h"
#include "soms/io/detail/tiles/tile_meshes.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace soms::detail {

namespace {

constexpr std::size_t kTileHeader = 12;       ///< a word, the version, the length
constexpr std::size_t kCompositeHeader = 16;  ///< and the number of tiles
constexpr int kDeepestComposite = 8;

/// Reads contents, and those in them.
class ContentReader {
 public:
  ContentReader(Source& source, const TileFrame& frame, const std::function<std::string()>& place,
                TileLeftOut& left_out)
      : source_(source), frame_(frame), place_(place), left_out_(left_out) {}

  /// The content from byte `begin` to `end`; nothing where it is left out.
  [[nodiscard]] std::optional<Mesh> read(std::size_t begin, std::size_t end, int depth);

 private:
  [[nodiscard]] Mesh read_composite(std::size_t begin, std::size_t end, int depth);

  Source& source_;
  TileFrame frame_;
  const std::function<std::string()>& place_;
  TileLeftOut& left_out_;
};

std::optional<Mesh> ContentReader::read(std::size_t begin, std::size_t end, int depth) {
  const std::string_view bytes = source_.bytes.substr(begin, end - begin);
  if (is_b3dm(bytes)) {
    return read_b3dm(source_, begin, end, frame_);
  }
  if (is_composite(bytes)) {
    return read_composite(begin, end, depth);
  }
  for (const auto& [magic, count] :
       {std::pair{"i3dm", &left_out_.instances}, std::pair{"pnts", &left_out_.points},
        std::pair{"vctr", &left_out_.vectors}, std::pair{"geom", &left_out_.vectors}}) {
    if (bytes.starts_with(magic)) {
      count->add(place_);
      return std::nullopt;
    }
  }
  if (is_glb(bytes) || is_gltf(bytes)) {
    return read_gltf_tile(source_, begin, end, {.frame = frame_.frame, .turned = frame_.turned});
  }
  source_.fail_byte(begin, ErrorKind::bad_file,
                    "no content of a tile begins with " + in_quotes(bytes.substr(0, 4)),
                    "give b3dm, cmpt, glb or gltf files");
}

Mesh ContentReader::read_composite(std::size_t begin, std::size_t end, int depth) {
  const auto number_at = [&](std::size_t at) {
    return little_endian<std::uint32_t>(source_.bytes, at);
  };
  const auto fail = [&](std::size_t at, const std::string& what) {
    source_.fail_byte(at, ErrorKind::bad_file, what, kRepairTile);
  };
  if (depth >= kDeepestComposite) {
    fail(begin, "composites are nested more than " + std::to_string(kDeepestComposite) + " deep");
  }
  const std::size_t size = tile_size(source_, begin, end, kCompositeHeader);
  const std::size_t stated_end = begin + size;
  std::vector<NamedMesh> meshes;
  std::size_t at = begin + kCompositeHeader;
  for (std::uint32_t i = 0; i < number_at(begin + kTileHeader); ++i) {
    check(source_.limits);
    if (stated_end - at < kTileHeader) {
      fail(at, "tile " + std::to_string(i) + " of the composite is cut off");
    }
    const std::size_t inside = number_at(at + 8);
    if (inside < kTileHeader || inside > stated_end - at) {
      fail(at + 8, "tile " + std::to_string(i) + " of the composite states " +
                       std::to_string(inside) + " bytes, but " + std::to_string(stated_end - at) +
                       " are left");
    }
    if (std::optional<Mesh> mesh = read(at, at + inside, depth + 1)) {
      if (!source_.budget.take(2 * sizeof(NamedMesh))) {
        source_.fail_memory(2 * sizeof(NamedMesh));
      }
      meshes.push_back({std::to_string(i), std::move(*mesh)});
    }
    at += inside;
  }
  Mesh joined_mesh = join_tiles(source_, std::move(meshes));
  LeftOut surplus;
  surplus.add([&] { return "at " + source_.byte_of(at); }, end - at);
  constexpr std::uint64_t kMostPadding = 7;
  if (surplus.count() > kMostPadding) {
    add_note(joined_mesh.notes, surplus, "surplus bytes after the last tile of a composite");
  }
  return joined_mesh;
}

}  // namespace

bool is_b3dm(std::string_view bytes) {
  return bytes.starts_with("b3dm");
}

bool is_composite(std::string_view bytes) {
  return bytes.starts_with("cmpt");
}

void TileLeftOut::add_notes(std::vector<std::string>& notes) const {
  add_note(notes, instances, "instanced models (i3dm), not read");
  add_note(notes, points, "point clouds (pnts), which are not triangles");
  add_note(notes, vectors, "vector data (vctr, geom), not read");
}

Mesh read_tile_content(Source& source, const TileFrame& frame,
                       const std::function<std::string()>& place, TileLeftOut& left_out) {
  const bool allow_empty = std::exchange(source.allow_empty, true);
  std::optional<Mesh> mesh =
      ContentReader(source, frame, place, left_out).read(0, source.bytes.size(), 0);
  source.allow_empty = allow_empty;
  return mesh ? std::move(*mesh) : Mesh{};
}

void state_earth_centered(Mesh& mesh) {
  mesh.up = UpAxis::unknown;
  mesh.georeference = {.crs = "EPSG:4978"};
}

void finish_tiles(Source& source, Mesh& mesh) {
  if (mesh.triangles.empty() && !source.allow_empty) {
    source.fail(ErrorKind::empty_mesh,
                "no triangles (" + std::to_string(mesh.vertices.size()) + " vertices" +
                    (mesh.notes.empty() ? "" : "; " + joined(mesh.notes)) + ")",
                "give tiles with triangles, or allow an empty one (allow_empty)");
  }
  make_ids_unique(source, mesh);
  mesh.source = source.name;
  mesh.unit = 1;
  mesh.up = UpAxis::z;
  if (!mesh.triangles.empty()) {
    const Box box = bounds(mesh);
    constexpr double kNear = 100'000;
    const double height = geodetic_place((box.lower + box.upper) * 0.5).height;
    if (std::abs(height) <= kNear) {
      state_earth_centered(mesh);
    }
  }
}

Mesh read_tile(Source& source) {
  TileLeftOut left_out;
  Mesh mesh = read_tile_content(
      source, {}, [] { return "in the file"; }, left_out);
  left_out.add_notes(mesh.notes);
  finish_tiles(source, mesh);
  return mesh;
}

}  // namespace soms::detail
