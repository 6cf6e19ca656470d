/// \file
/// What paved streets have: sidewalks with kerbs, and marks on the lanes.
#pragma once

#include "soms/generate/city.h"

#include <cstdint>

namespace soms::detail {

/// Whether a sidewalk covers a point.
[[nodiscard]] bool on_sidewalk(const City& city, double x, double y);

/// Height of a sidewalk above its street.
inline constexpr double kKerb = 0.12;

/// Triangles of sidewalks and marks together; 0 for bare streets. What would take more than a tenth
/// of the city's triangles is left out.
[[nodiscard]] std::uint64_t pavement_triangles(const City& city);

/// Appends the parts `sidewalks`, a closed ring about each block, and `lane marks`, sheets 1 cm
/// above the street.
void add_pavement(City& city);

}  // namespace soms::detail
