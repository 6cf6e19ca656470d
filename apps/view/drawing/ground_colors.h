/// \file
/// Colors of the ground that a city stands on.
#pragma once

#include "soms/geometry/mesh.h"

#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// Gives streets and terrain the gray of ground, so that what stands on them is set off. `pieces`
/// are the connected pieces of a mesh without parts. Its ground is a flat piece at least half as
/// wide as the mesh, below other pieces; flat pieces that lie on it are sidewalks and marks. A mesh
/// without such a piece stays as it is.
void color_ground(const Mesh& mesh, const std::vector<std::uint32_t>& pieces,
                  std::vector<Color>& colors);

/// The same of a mesh with parts, which soms names: terrain, roads, sidewalks and lane marks.
void color_named_ground(const Mesh& mesh, std::vector<Color>& colors);

}  // namespace soms::view
