/// \file
/// Which markers of a draw list a picture shows, and where.
#pragma once

#include "apps/view/drawing/camera.h"
#include "apps/view/drawing/draw_list.h"

#include <cstdint>
#include <span>
#include <vector>

namespace soms::view {

/// What is seen at least this large needs no marker, in pixels.
inline constexpr double kSeenWithoutMarker = 12;

/// Markers nearer to each other than this become one, in pixels.
inline constexpr double kMarkersApart = 24;

/// A marker in a picture.
struct PlacedMarker {
  PixelPoint at = {};
  std::uint64_t count = 0;
  Color color = {};
};

/// The markers whose places are inside the picture and whose subjects are small in it, or that are
/// always drawn. Those near each other are one, at their mean place weighted by count.
/// \cost O(markers * markers placed).
[[nodiscard]] std::vector<PlacedMarker> place_markers(std::span<const Marker> markers,
                                                      const Camera& camera, Size size);

}  // namespace soms::view
