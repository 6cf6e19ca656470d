/// \file
/// Meshes cut in tiles for drawing: small floats about an origin of their own, so that nothing
/// shakes at map coordinates, and short runs of triangles that can be left out one by one.
#pragma once

#include "soms/base/parallel.h"

#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::view {

/// A corner as the device gets it: `origin + scale * (x, y, z)` of its tile.
struct TileVertex {
  float x = 0;  ///< -1 to 1
  float y = 0;
  float z = 0;
  Color color;
};

/// A run of triangles that lie together.
struct Tile {
  Box bounds;
  Vec3 origin;              ///< center of `bounds`
  double scale = 1;         ///< half the longest side of `bounds`, or 1 where that is 0
  std::uint32_t first = 0;  ///< first triangle
  std::uint32_t count = 0;  ///< triangles, the large ones first
  /// A coarse copy (`stand_in.h`), likewise; none for tiles of few triangles.
  std::uint32_t stand_in_first = 0;
  std::uint32_t stand_in_count = 0;
  /// A far coarser one: a box for some houses, or one box for all; none where the other is as
  /// short.
  std::uint32_t least_first = 0;
  std::uint32_t least_count = 0;
};

struct TiledMesh {
  std::vector<TileVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< 3 a triangle, into `vertices`; stand-ins come last
  std::vector<Tile> tiles;
};

/// How finely to cut.
struct TileOptions {
  std::uint32_t triangles = 16384;  ///< a tile of a small mesh has no more
  std::uint32_t most_tiles = 128;   ///< no mesh has more; its tiles are larger instead
  std::uint32_t stand_in_of = 12;   ///< one triangle of a stand-in for so many; 0: no stand-ins
};

/// Cuts a mesh at medians of its triangles' centers. Each triangle is in one tile; within a tile
/// triangles come in classes of size, each class at most four times as long as the next, so that a
/// first part of a tile shows most of it.
///
/// \shape `colors`: one a triangle, or empty.
/// \pre The mesh passes `check(Mesh)`.
/// \errors ErrorKind::cancelled, and what the progress throws, which any thread reports.
/// \cost O(n log tiles); the stand-ins are made by the threads of `limits`.
[[nodiscard]] TiledMesh cut_in_tiles(const Mesh& mesh, std::span<const Color> colors,
                                     const TileOptions& options = {}, const Limits& limits = {});

}  // namespace soms::view
