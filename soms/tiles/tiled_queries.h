/// \file
/// Questions about tiles: the answers of the whole model, bit for bit, from the tiles that a
/// question meets.
///
/// Triangles are numbered through all sources, in their order: triangle i of source s is
/// `sources[s].first + i`. The queries of the same names give these answers of one shape with all
/// triangles. What they do not promise may differ: the pair that mode `any` and `within` name, and
/// costs, which add up those of the tiles.
///
/// Questions whose answers do not come from one triangle or pair are not here. A crossing of
/// `all_hits` through an edge may be of two tiles; `contains`, `winding` and `solid` need whole
/// surfaces.
#pragma once

#include "soms/base/limits.h"
#include "soms/query/body.h"
#include "soms/query/closest.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/within.h"
#include "soms/tiles/tile_set.h"

#include <span>

namespace soms {

/// Which triangles of a mover touch those of tiles, at each pose?
/// \errors  As `overlap` of shapes, and as `TileSet::open_tile`; ErrorKind::usage for a limit, as
///          pairs come tile by tile.
/// \cost    As `overlap` for the tiles whose boxes meet the mover's.
[[nodiscard]] OverlapBatch overlap(const Shape& mover, std::span<const Pose> poses,
                                   const TiledBody& fixed, const OverlapOptions& options = {},
                                   const Limits& limits = {});

/// How far is a mover from tiles, at each pose?
/// \errors  As `distance` of shapes, and as `TileSet::open_tile`.
/// \cost    As `distance` for the tiles that are not farther than what was found before.
[[nodiscard]] DistanceBatch distance(const Shape& mover, std::span<const Pose> poses,
                                     const TiledBody& fixed, const DistanceOptions& options = {},
                                     const Limits& limits = {});

/// Is a mover within a clearance of tiles, at each pose?
/// \errors  As `within` of shapes, and as `TileSet::open_tile`.
/// \cost    As `within` for the tiles that are within the clearance, up to one that decides.
[[nodiscard]] WithinBatch within(const Shape& mover, std::span<const Pose> poses,
                                 const TiledBody& fixed, double clearance,
                                 const Limits& limits = {});

/// Where is the surface nearest to each point?
/// \errors  As `closest` of a body, and as `TileSet::open_tile`.
[[nodiscard]] ClosestBatch closest(const TiledBody& body, std::span<const Vec3> points,
                                   const ClosestOptions& options = {}, const Limits& limits = {});

/// What does each ray hit first? `RayOptions::skip` is a number among all triangles.
/// \errors  As `closest_hit` of a body, and as `TileSet::open_tile`.
[[nodiscard]] ClosestHitBatch closest_hit(const TiledBody& body, std::span<const Ray> rays,
                                          const RayOptions& options = {},
                                          const Limits& limits = {});

/// Does each ray hit anything?
/// \errors  As `any_hit` of a body, and as `TileSet::open_tile`.
[[nodiscard]] AnyHitBatch any_hit(const TiledBody& body, std::span<const Ray> rays,
                                  const RayOptions& options = {}, const Limits& limits = {});

}  // namespace soms
