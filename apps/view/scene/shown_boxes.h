/// \file
/// Boxes of trees as they are drawn: one level, or what a traversal looked at.
#pragma once

#include "apps/view/drawing/draw_list.h"
#include "apps/view/scene/view_options.h"
#include "apps/view/scene/view_scene.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// Box groups, and how many boxes there are that `ViewOptions::most_boxes` may have cut.
struct ShownBoxes {
  std::vector<BoxGroup> groups;
  std::uint64_t boxes = 0;
};

/// Boxes that `options` ask for: of a level in the body's own coordinates, with its pose; of a
/// traversal in world coordinates, as it tested them.
/// \errors ErrorKind::usage for a body that is not there and for a level below 1.
[[nodiscard]] ShownBoxes shown_boxes(ViewScene& scene, const ViewOptions& options);

/// Nodes of a level of a tree, level 1 being the root alone, with or without the leaves above it.
/// \errors ErrorKind::usage for a level below 1.
[[nodiscard]] std::vector<std::uint32_t> nodes_of_level(const Tree& tree, int level,
                                                        bool leaves_above);

}  // namespace soms::view
