/// \file
/// Colors by which buildings are distinguished, and the parts that triangles belong to.
#pragma once

#include "soms/geometry/mesh.h"

#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// Innermost part of each triangle, as `part_of` says; Part::kNoParent without parts.
/// \cost O(triangles + sizes of all parts), where `part_of` would take O(parts) for each triangle.
[[nodiscard]] std::vector<std::uint32_t> parts_of_triangles(const Mesh& mesh);

/// Connected pieces of a mesh, numbered by their first triangle: triangles are connected when they
/// share a vertex, by number or by place. \cost Nearly linear.
[[nodiscard]] std::vector<std::uint32_t> pieces_of_triangles(const Mesh& mesh);

/// One color a triangle: by innermost part; without parts by connected piece; where pieces are too
/// small to be buildings, as loose triangles are, by place on a coarse grid.
[[nodiscard]] std::vector<Color> colors_by_building(const Mesh& mesh);

}  // namespace soms::view
