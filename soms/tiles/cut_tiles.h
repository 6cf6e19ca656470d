/// \file
/// Cuts models into tiles: `tile_set.h` opens them.
///
/// \code
/// const auto folder = std::filesystem::temp_directory_path() / "soms-town";
/// std::filesystem::remove_all(folder);
/// soms::TileCutter cutter(folder, {.most = 5'000});
/// cutter.add(soms::generate_city({.triangles = 20'000}).mesh);
/// cutter.finish();
/// const soms::TiledBody town{soms::TileSet::open(folder)};
/// const soms::Shape ball(soms::generate_sphere(80));
/// const std::vector<soms::Pose> poses{soms::Pose{}, soms::Pose::translation(0, 0, 90)};
/// const soms::DistanceBatch answer = soms::distance(ball, poses, town);
/// std::cout << town.tiles.triangles() << " triangles; on the ground: " << std::boolalpha
///           << (answer.upper[0] == 0) << ", above: " << (answer.lower[1] > 80) << '\n';
/// \endcode
/// It prints:
/// \verbatim
/// 20000 triangles; on the ground: true, above: true
/// \endverbatim
#pragma once

#include "soms/base/limits.h"
#include "soms/geometry/mesh.h"
#include "soms/tiles/tile_set.h"
#include "soms/tree/shape.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace soms {

/// How models are cut.
struct CutOptions {
  std::size_t most = 1'000'000;  ///< most triangles of a tile; above 0
  ShapeOptions shape = {};       ///< how the trees are built; no canonical tree is kept

  [[nodiscard]] bool operator==(const CutOptions&) const = default;
};

/// The triangles of a tile, ascending; and whether one of its parts is in another tile, too.
struct TileCut {
  std::vector<TriangleId> triangles;
  bool splits_part = false;

  [[nodiscard]] bool operator==(const TileCut&) const = default;
};

/// Shares the triangles of a mesh out: each is in exactly one tile. Parts are kept whole, but for
/// those of more than `most` triangles; a mesh without parts is cut by its triangles. Sets are
/// halved across their longest side until they are small enough, so tiles have `most / 2` triangles
/// or more where parts are small.
/// \errors  ErrorKind::cancelled.
/// \cost    O(n log^2 n).
[[nodiscard]] std::vector<TileCut> cut_mesh(const MeshView& mesh, std::size_t most,
                                            const Limits& limits = {});

/// A mesh of some triangles of another one, numbered in the order that is given. It keeps the
/// vertices that they use, the parts that have any of them, and the faces' numbers.
/// \pre `triangles` ascend.
[[nodiscard]] Mesh extract(const MeshView& mesh, std::span<const TriangleId> triangles);

/// Writes a folder of tiles, one model after the other; only one need be in memory. The same calls
/// go on where a run was ended: a model whose tiles are there and whole is not cut again.
class TileCutter {
 public:
  /// The folder is made when the first tile is written.
  /// \errors  ErrorKind::cannot_write; usage for a folder with other files than tiles.
  TileCutter(std::filesystem::path folder, const CutOptions& options);

  /// Cuts the next model, and writes its tiles. False if they were there.
  /// The folder must be of the same models and options, as far as it was cut.
  /// \errors  ErrorKind::usage for another folder, and for a model whose unit, up axis or
  ///          georeference is not that of those before; out_of_range for too many triangles;
  ///          cannot_write; cancelled.
  bool add(const MeshView& mesh, const Limits& limits = {});

  /// Writes the manifest, which makes the folder a set of tiles.
  /// \errors  ErrorKind::cannot_write; usage for a folder that was cut from more models.
  void finish();

  /// What has been written so far.
  [[nodiscard]] const TileManifest& manifest() const { return manifest_; }

 private:
  [[nodiscard]] std::filesystem::path receipt() const;
  [[nodiscard]] std::string question(const MeshView& mesh, const TileSource& source) const;
  bool take_receipt(const MeshView& mesh, const TileSource& source);
  void keep(const TileSource& source, std::span<const Tile> tiles);
  void write_tiles(const MeshView& mesh, const TileSource& source, const Limits& limits);
  void check_statements(const MeshView& mesh);

  std::filesystem::path folder_;
  CutOptions options_;
  TileManifest manifest_;
  bool begun_ = false;
};

/// As those of tile_set.h.
std::ostream& operator<<(std::ostream& out, const CutOptions& value);
std::ostream& operator<<(std::ostream& out, const TileCut& value);

}  // namespace soms
