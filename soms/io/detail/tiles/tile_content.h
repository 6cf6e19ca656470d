/// \file
/// The contents of tiles of 3D Tiles: batched models (b3dm), composites (cmpt) and glTF.
#pragma once

#include "soms/geometry/mesh.h"
#include "soms/io/detail/affine.h"
#include "soms/io/detail/left_out.h"
#include "soms/io/detail/source.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace soms::detail {

/// True if the bytes begin with the first word of a batched model.
[[nodiscard]] bool is_b3dm(std::string_view bytes);

/// True if the bytes begin with the first word of a composite.
[[nodiscard]] bool is_composite(std::string_view bytes);

/// Contents that are no triangles, or that are not read.
struct TileLeftOut {
  LeftOut instances;  ///< instanced models (i3dm)
  LeftOut points;     ///< point clouds (pnts)
  LeftOut vectors;    ///< vector data (vctr, geom)

  void add_notes(std::vector<std::string>& notes) const;
};

/// How a tile stands in the mesh.
struct TileFrame {
  Affine frame;        ///< from the axes of the tile to those of the mesh
  bool turned = true;  ///< glTF in it is y up, and is turned
};

/// The mesh of a content, its batches and nodes as parts, in the axes of the mesh of all tiles.
/// What is left out is counted in `left_out`, at `place()`. \errors ErrorKind::bad_file (names the
/// byte, or the path in the JSON), unsupported, and those of
///         `read_gltf`.
/// \source OGC 18-053r2, 3D Tiles 1.0; OGC 22-025r4, 3D Tiles 1.1
[[nodiscard]] Mesh read_tile_content(Source& source, const TileFrame& frame,
                                     const std::function<std::string()>& place,
                                     TileLeftOut& left_out);

/// A file of one such content, in the axes of its tile: z is up, or none is where the coordinates
/// are Earth-centered. \errors As `read_mesh`.
[[nodiscard]] Mesh read_tile(Source& source);

/// States that coordinates are Earth-centered (EPSG:4978): no axis is up.
void state_earth_centered(Mesh& mesh);

/// States unit and axis of a mesh of tiles: meters; no axis is up where the middle of the mesh lies
/// within 100 km of the surface of the Earth, which is Earth-centered, and z elsewhere. \errors
/// ErrorKind::empty_mesh.
void finish_tiles(Source& source, Mesh& mesh);

}  // namespace soms::detail
