/// \file
/// What is written and drawn upon a finished picture: labels, markers, key, title, scale and north.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <vector>

namespace soms::view {

/// A straight stroke of a round pen, in points from the upper left corner.
struct OverlayStroke {
  PixelPoint from;
  PixelPoint to;
  Color color;
  double width = 1;
};

/// Strokes, the first lowest, and what they are of.
struct Overlay {
  std::vector<OverlayStroke> strokes;
  std::uint64_t labels = 0;
  std::uint64_t markers = 0;  ///< after merging
  std::uint64_t marked = 0;   ///< the sum of their counts
};

/// All of a list's, in a picture of so many points. Entries of the key for contacts are left out
/// where the picture shows none.
[[nodiscard]] Overlay overlay_of(const DrawList& list, const Camera& camera, Size size);

/// Length of the scale bar in meters and in pixels: round, and at most a fifth of the picture's
/// width, at the distance of the camera's target.
struct ScaleBar {
  double meters = 0;
  double pixels = 0;
};

/// \pre `meters` > 0: of a unit.
[[nodiscard]] ScaleBar scale_bar(const Camera& camera, Size size, double meters);

}  // namespace soms::view
