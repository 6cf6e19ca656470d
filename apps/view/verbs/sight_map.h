/// \file
/// A map of what a point sees: a viewshed, made of rays.
#pragma once

#include "soms/base/parallel.h"
#include "soms/base/vector.h"

#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <string>

namespace soms::view {

/// A map, and what it shows.
struct SightMap {
  std::string text;            ///< SVG, or a grid of numbers
  double cell = 0;             ///< side of its square cells
  std::uint64_t surface = 0;   ///< cells with a surface at their center, seen from above
  std::uint64_t in_sight = 0;  ///< of these, those that the point sees
};

/// A map of a scene seen from above, north up. Each cell shows the highest surface at its center:
/// 800 of them make the longer side of the map, which is the scene and the point with a rim around
/// them. The point is tested against the very place that the ray from above hits (`seen_from`).
/// Outlines are made straighter so that the file stays below about 400 KB. \errors As
/// `ViewScene::first_hits`.
[[nodiscard]] SightMap draw_sight_map(const ViewScene& scene, const Vec3& observer,
                                      const Limits& limits = {});

/// The cells of `draw_sight_map` as an ESRI ASCII grid: 1 in sight, 0 hidden, -9999 without a
/// surface. Corner and cells are in coordinates of the scene. \errors As `draw_sight_map`.
[[nodiscard]] SightMap sight_grid(const ViewScene& scene, const Vec3& observer,
                                  const Limits& limits = {});

}  // namespace soms::view
