#include "apps/view/drawing/markers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace soms::view {

namespace {

bool are_near(const PlacedMarker& a, const PlacedMarker& b) {
  return std::hypot(a.at.x - b.at.x, a.at.y - b.at.y) < kMarkersApart;
}

void merge_marker(PlacedMarker& into, const PlacedMarker& other) {
  const auto a = static_cast<double>(into.count);
  const auto b = static_cast<double>(other.count);
  const double whole = std::max(a + b, 1.0);
  into.at = {(into.at.x * a + other.at.x * b) / whole, (into.at.y * a + other.at.y * b) / whole};
  into.count += other.count;
}

/// Adds a marker, to the first that is near where one is.
void add_marker(std::vector<PlacedMarker>& placed, const PlacedMarker& marker) {
  const auto near = std::find_if(placed.begin(), placed.end(),
                                 [&](const PlacedMarker& m) { return are_near(m, marker); });
  if (near == placed.end()) {
    placed.push_back(marker);
  } else {
    merge_marker(*near, marker);
  }
}

}  // namespace

std::vector<PlacedMarker> place_markers(std::span<const Marker> markers, const Camera& camera,
                                        Size size) {
  std::vector<PlacedMarker> placed;
  for (const Marker& marker : markers) {
    const auto seen = project(camera, size, marker.at);
    if (!seen || seen->pixel.x < 0 || seen->pixel.y < 0 || seen->pixel.x >= size.width ||
        seen->pixel.y >= size.height) {
      continue;
    }
    const double pixel = length_of_pixel(camera, size, seen->depth);
    if (marker.always || 2 * marker.reach < kSeenWithoutMarker * pixel) {
      add_marker(placed, {seen->pixel, marker.count, marker.color});
    }
  }
  // A merged marker has moved, and may be near another now.
  for (std::size_t before = placed.size() + 1; placed.size() < before;) {
    before = placed.size();
    std::vector<PlacedMarker> again;
    for (const PlacedMarker& marker : placed) {
      add_marker(again, marker);
    }
    placed = std::move(again);
  }
  return placed;
}

}  // namespace soms::view
