/// \file
/// Where the labels of a draw list stand in a picture: beside what they name, and not over each
/// other.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstddef>
#include <span>
#include <vector>

namespace soms::view {

/// A label in a picture, in pixels from its upper left corner.
struct PlacedLabel {
  std::size_t label = 0;  ///< which of the list
  PixelPoint upper_left = {};
  PixelPoint lower_right = {};
};

/// Those labels that are written. A label stands beside the middle of the part of its segment that
/// the picture shows, clear of the segment's line, and inside the picture where that has room. It
/// is left out if no part of its segment is seen, or if it would cover one of an earlier label.
/// \cost O(labels * labels written).
[[nodiscard]] std::vector<PlacedLabel> place_labels(std::span<const Label> labels,
                                                    const Camera& camera, Size size);

}  // namespace soms::view
