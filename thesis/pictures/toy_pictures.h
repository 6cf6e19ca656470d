/// \file
/// Pictures of toy sets: triangles, midpoints and boxes, and what a rule's plane does to them.
#pragma once

#include "thesis/pictures/drawing.h"
#include "thesis/trees/toy_sets.h"

#include <string_view>
#include <vector>

namespace soms::reproduce {

/// Names of the axes 0, 1 and 2.
inline constexpr std::string_view kAxisNames = "xyz";

/// Legend of such panels; with `sides` also of what a plane divides.
[[nodiscard]] std::vector<Key> toy_keys(bool sides);

/// Triangles, midpoints and boxes of a set. The mesh must outlive the panel.
[[nodiscard]] Panel toy_panel(const Mesh& mesh, const ToySplit& split);

/// The same with the plane of the rule and what lies on its two sides; the note tells of both.
[[nodiscard]] Panel divided_toy_panel(const Mesh& mesh, const ToySplit& split);

}  // namespace soms::reproduce
